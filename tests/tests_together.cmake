# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later

# What deal.II's headers leave to every file takes 2 s of a processor, and to link two hundred
# libraries one more. So many tests are compiled as one file, in which each is a namespace:
#
#   #include <...>                       what the tests include, once
#   namespace test_supports
#   {
#   #include ".../tests/supports.cc"     its headers are here already, its main() is run() of several_tests.h
#   }
#   ...
#   int main(...)                        runs the test that the environment variable TEST names
#
# deal.II's macros take the program for that of the test NAME if they find it under the name of
# the target that they would make, and put in front of its command what
# tests_NAME_RUNARGS_PREFIX says.

# At most.
set(TESTS_OF_A_PROGRAM 18)

# names_of_tests(<result>)
# Those tests NAME.cc with an output that deal.II's macros take up in this build.
function(names_of_tests _result)
  set(_names)
  file(GLOB _outputs RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} CONFIGURE_DEPENDS *.output)
  foreach(_output ${_outputs})
    string(REGEX REPLACE "[.].*" "" _name ${_output})
    if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${_name}.cc AND "tests/${_name}" MATCHES "${TEST_PICKUP_REGEX}"
        AND (NOT _output MATCHES "[.](debug|release)[.]" OR CMAKE_MATCH_1 STREQUAL _build_type))
      list(APPEND _names ${_name})
    endif()
  endforeach()
  list(REMOVE_DUPLICATES _names)
  set(${_result} ${_names} PARENT_SCOPE)
endfunction()

# add_tests_together(<number> <name of a test> ...)
# One program for these tests.
function(add_tests_together _number)
  set(_includes)
  set(_bodies)
  set(_rows)
  set(_files)
  foreach(_name ${ARGN})
    set(_file ${CMAKE_CURRENT_SOURCE_DIR}/${_name}.cc)
    list(APPEND _files ${_file})
    file(STRINGS ${_file} _lines REGEX "^#include ")
    list(APPEND _includes ${_lines})
    string(APPEND _bodies "\nnamespace test_${_name}\n{\n#include \"${_file}\"\n}\n")
    string(APPEND _rows "    {\"${_name}\", test_${_name}::run},\n")
  endforeach()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${_files})
  list(REMOVE_DUPLICATES _includes)
  list(SORT _includes)
  string(REPLACE ";" "\n" _includes "${_includes}")

  set(_program tests_together_${_number})
  set(_source ${CMAKE_CURRENT_BINARY_DIR}/${_program}.cc)
  file(CONFIGURE OUTPUT ${_source} @ONLY CONTENT
"@_includes@
#include \"several_tests.h\"
@_bodies@
#undef main

int
main(int argc, char *argv[])
{
  return run_test_of_environment(argc, argv, {
@_rows@  });
}
")
  add_executable(${_program} EXCLUDE_FROM_ALL ${_source})
  deal_ii_setup_target(${_program})
  target_include_directories(${_program} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  target_compile_definitions(${_program} PRIVATE SOURCE_DIR="${CMAKE_CURRENT_SOURCE_DIR}")
  target_link_libraries(${_program} ${TEST_LIBRARIES})
  foreach(_name ${ARGN})
    add_executable(tests.${_name}.${_build_type} ALIAS ${_program})
    set(tests_${_name}_RUNARGS_PREFIX env TEST=${_name} PARENT_SCOPE)
  endforeach()
endfunction()

string(TOLOWER "${CMAKE_BUILD_TYPE}" _build_type)
names_of_tests(_names)
# (It takes arguments, and has an exit status.)
list(REMOVE_ITEM _names fuzz)
# (All that TEST_PICKUP_REGEX takes up may be runs.)
if(NOT _names)
  return()
endif()
# An even number of programs of the same length, so that neither of two processors waits for the other at the end.
list(LENGTH _names _length)
math(EXPR _n_programs "2 * ((${_length} + 2 * ${TESTS_OF_A_PROGRAM} - 1) / (2 * ${TESTS_OF_A_PROGRAM}))")
foreach(_number RANGE 1 ${_n_programs})
  math(EXPR _begin "(${_number} - 1) * ${_length} / ${_n_programs}")
  math(EXPR _n_some "${_number} * ${_length} / ${_n_programs} - ${_begin}")
  list(SUBLIST _names ${_begin} ${_n_some} _some)
  add_tests_together(${_number} ${_some})
endforeach()
