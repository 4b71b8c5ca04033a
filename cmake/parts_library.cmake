# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later

# Everything but main.cc is a library, so that tests can link any part of it, and a
# package can have it for several processors.

include(CheckCXXCompilerFlag)
include(${CMAKE_CURRENT_LIST_DIR}/wide_batches.cmake)

file(GLOB_RECURSE PARTS_SOURCES CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/source/*.cc)
list(REMOVE_ITEM PARTS_SOURCES ${CMAKE_SOURCE_DIR}/source/app/main.cc)
# Classes in several files: the first includes the others.
list(FILTER PARTS_SOURCES EXCLUDE REGEX
  "source/(contact_run/(checkpoint|discrete_body_)|contact/contact_set_|mechanics/solid_operator_(initial_stress|preconditioning|states)|bounds/(limit_load_analysis|stress/stress_program)_)")
if(TRILINOS_SOLVERS)
  list(REMOVE_ITEM PARTS_SOURCES ${CMAKE_SOURCE_DIR}/source/solver/matrix_preconditioner_gathered.cc)
else()
  list(REMOVE_ITEM PARTS_SOURCES ${CMAKE_SOURCE_DIR}/source/solver/matrix_preconditioner_trilinos.cc)
endif()
if(NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  list(REMOVE_ITEM PARTS_SOURCES ${CMAKE_SOURCE_DIR}/source/base/names_of_clang.cc)
endif()

# The bounds are a library of their own, without which a program can be built; in a package, with its
# libraries for several processors, they are a part of these.
set(BOUNDS_SOURCES ${PARTS_SOURCES})
list(FILTER BOUNDS_SOURCES INCLUDE REGEX "/source/(bounds/|app/with_bounds)")
list(REMOVE_ITEM PARTS_SOURCES ${BOUNDS_SOURCES})
if(STRICT_BOUNDS)
  list(REMOVE_ITEM PARTS_SOURCES ${CMAKE_SOURCE_DIR}/source/app/without_bounds.cc)
  if(PACKAGE_PROCESSORS)
    list(APPEND PARTS_SOURCES ${BOUNDS_SOURCES})
  endif()
endif()

set(_simd_sources ${PARTS_SOURCES})
list(FILTER _simd_sources INCLUDE REGEX "source/simd/")
set_source_files_properties(${_simd_sources} PROPERTIES
  SKIP_PRECOMPILE_HEADERS ON SKIP_UNITY_BUILD_INCLUSION ON)
# Set-up code, and much of it: optimise little, in favour of the compile time.
set_source_files_properties(
  ${CMAKE_SOURCE_DIR}/source/simd/matrix_free_2d.cc
  ${CMAKE_SOURCE_DIR}/source/simd/matrix_free_3d.cc
  ${CMAKE_SOURCE_DIR}/source/simd/shape_info_and_faces.cc
  PROPERTIES COMPILE_OPTIONS "-O1;-g0")

# Regions of OpenMP are in one file only.
set_source_files_properties(${CMAKE_SOURCE_DIR}/source/bounds/conic/multifrontal_factor.cc PROPERTIES
  COMPILE_OPTIONS "${OpenMP_CXX_FLAGS}" SKIP_PRECOMPILE_HEADERS ON SKIP_UNITY_BUILD_INCLUSION ON)

if(ONE_UNIT_PER_MODULE)
  foreach(_source ${PARTS_SOURCES} ${BOUNDS_SOURCES})
    get_filename_component(_module ${_source} DIRECTORY)
    # Small rooms share a unit.
    foreach(_rooms "app|problem" "input|output|restart" "adaptivity|evaluation" "loads|mechanics"
        "bounds/(conic|mesh|body)" "bounds/(mechanism|error)")
      if(_module MATCHES "/source/(${_rooms})$")
        string(MAKE_C_IDENTIFIER "${_rooms}" _module)
      endif()
    endforeach()
    # Four exceptions: what depends on STRICT_BOUNDS; kernels, which take as long as all the rest of their folder;
    # both analyses of bounds have local functions of the same name; and a header of Amesos has names of deal.II's.
    if(NOT _source MATCHES "source/(app/with|simd/|mechanics/(solid_kernel|level_kernel)|bounds/limit_load_analysis|solver/matrix_preconditioner_)")
      set_source_files_properties(${_source} PROPERTIES UNITY_GROUP "${_module}")
    endif()
  endforeach()
endif()

# set_build_options(<target> [<flag of the processor> ...])
# What the options of this build ask of the compiler and the linker.
function(set_build_options _target)
  target_compile_options(${_target} PUBLIC -Wall -Wextra)
  # deal.II hands on flags that the compiler of its package knows, and all libraries that its own one needs, which
  # Debian's GCC leaves out where a program has no use for them: they cost a second of a processor at each start.
  if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    target_compile_options(${_target} PUBLIC
      -Wno-unknown-warning-option $<$<CONFIG:Release>:-Wno-ignored-optimization-argument>)
    target_link_options(${_target} PUBLIC -Wl,--as-needed)
  endif()
  # (include/base/enum_names.h)
  if(DEAL_II_WITH_MAGIC_ENUM)
    target_compile_features(${_target} PUBLIC cxx_std_20)
  endif()
  if(TRILINOS_SOLVERS)
    target_compile_definitions(${_target} PUBLIC WITH_TRILINOS_SOLVERS)
  endif()
  if(WARNINGS_AS_ERRORS)
    target_compile_options(${_target} PUBLIC -Werror)
  endif()
  if(ARGN)
    target_compile_options(${_target} PUBLIC -O3 ${ARGN})
    # (For AMD's processors, GCC calls a function for each copy of more than 128 bytes: of every tensor of batches.)
    check_cxx_compiler_flag("-mmove-max=512 -mstore-max=512" HAS_WIDE_COPIES)
    if(HAS_WIDE_COPIES)
      target_compile_options(${_target} PUBLIC -mmove-max=512 -mstore-max=512)
    endif()
  endif()
  if(NOT DEBUG_SYMBOLS)
    target_compile_options(${_target} PUBLIC -g0)
  endif()
  # deal.II's libraries are large: gold, the choice of some packages, takes twice as long.
  find_program(LLD ld.lld)
  if(LLD)
    # (Of the libraries that deal.II brings along, not all name all they need.)
    target_link_options(${_target} PUBLIC -fuse-ld=lld -Wl,--allow-shlib-undefined)
  endif()
  if(SANITIZE)
    # (deal.II binds references to null pointers that it does not use.)
    set(_sanitizers -fsanitize=address,undefined -fno-sanitize=null -fno-sanitize-recover=all)
    target_compile_options(${_target} PUBLIC ${_sanitizers} -O1 -g1)
    target_link_options(${_target} PUBLIC ${_sanitizers})
  endif()
endfunction()

# use_libraries_of_bounds(<target>)
function(use_libraries_of_bounds _target)
  target_include_directories(${_target} PUBLIC ${CHOLMOD_INCLUDE_DIR})
  target_link_libraries(${_target} ${CHOLMOD_LIBRARY} ${OpenMP_CXX_LIBRARIES})
endfunction()

# add_parts_library(<target> <STATIC or SHARED> [<flag of the processor> ...])
# With batches as wide as this processor's registers, where they work.
function(add_parts_library _target _type)
  set(_sources ${PARTS_SOURCES})
  set(_wide OFF)
  if(WIDER_THAN_DEAL_II AND CMAKE_BUILD_TYPE MATCHES "Release")
    try_wide_batches(_wide ${ARGN})
  endif()
  if(NOT _wide)
    list(FILTER _sources EXCLUDE REGEX "source/simd/")
  endif()

  add_library(${_target} ${_type} ${_sources})
  target_include_directories(${_target} PUBLIC ${CMAKE_SOURCE_DIR}/include ${CMAKE_BINARY_DIR}/include)
  deal_ii_setup_target(${_target})
  target_link_libraries(${_target} Boost::program_options PNG::PNG)
  if(PACKAGE_PROCESSORS AND STRICT_BOUNDS)
    use_libraries_of_bounds(${_target})
  endif()
  if(_wide)
    target_compile_definitions(${_target} PUBLIC WIDER_THAN_DEAL_II)
  endif()
  set_build_options(${_target} ${ARGN})
  # deal.II's headers are large: parse those that every file needs only once.
  target_precompile_headers(${_target} PRIVATE
    <deal.II/base/parameter_handler.h>
    <deal.II/base/quadrature_lib.h>
    <deal.II/base/symmetric_tensor.h>
    <deal.II/distributed/tria.h>
    <deal.II/dofs/dof_handler.h>
    <deal.II/dofs/dof_tools.h>
    <deal.II/fe/fe_q.h>
    <deal.II/fe/fe_system.h>
    <deal.II/grid/grid_generator.h>
    <deal.II/grid/grid_tools.h>
    <deal.II/lac/affine_constraints.h>
    <deal.II/lac/la_parallel_vector.h>
    <deal.II/matrix_free/fe_evaluation.h>
    <deal.II/matrix_free/matrix_free.h>
    <deal.II/numerics/vector_tools.h>)
  if(ONE_UNIT_PER_MODULE)
    set_target_properties(${_target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  endif()
endfunction()

# One library; or a shared one for any processor and, for each of PACKAGE_PROCESSORS, one
# more of the same name in a subfolder, of which the dynamic loader takes the best that
# the processor at hand can run.
if(NOT PACKAGE_PROCESSORS)
  add_parts_library(elasto_plastic_contact_parts STATIC ${PROCESSOR_FLAGS})
  if(STRICT_BOUNDS)
    add_library(elasto_plastic_contact_bounds STATIC ${BOUNDS_SOURCES})
    deal_ii_setup_target(elasto_plastic_contact_bounds)
    target_link_libraries(elasto_plastic_contact_bounds elasto_plastic_contact_parts)
    use_libraries_of_bounds(elasto_plastic_contact_bounds)
    target_precompile_headers(elasto_plastic_contact_bounds REUSE_FROM elasto_plastic_contact_parts)
    if(ONE_UNIT_PER_MODULE)
      set_target_properties(elasto_plastic_contact_bounds PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    endif()
    # What links the parts needs them, too: app/with_bounds.cc is there.
    set_property(TARGET elasto_plastic_contact_parts APPEND PROPERTY
      INTERFACE_LINK_LIBRARIES elasto_plastic_contact_bounds)
  endif()
else()
  set(PARTS_FOLDER ${CMAKE_BINARY_DIR}/parts)
  add_parts_library(elasto_plastic_contact_parts SHARED)
  set(PARTS_LIBRARIES elasto_plastic_contact_parts)
  set_target_properties(elasto_plastic_contact_parts PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${PARTS_FOLDER})
  foreach(_processor ${PACKAGE_PROCESSORS})
    add_parts_library(elasto_plastic_contact_parts_${_processor} SHARED -march=${_processor})
    list(APPEND PARTS_LIBRARIES elasto_plastic_contact_parts_${_processor})
    set_target_properties(elasto_plastic_contact_parts_${_processor} PROPERTIES
      OUTPUT_NAME elasto_plastic_contact_parts
      LIBRARY_OUTPUT_DIRECTORY ${PARTS_FOLDER}/glibc-hwcaps/${_processor})
  endforeach()
endif()
