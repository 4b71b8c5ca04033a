# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later

# What a program says that has been built with STRICT_BOUNDS=OFF. See message_test.cmake.
set(_cases ${CMAKE_SOURCE_DIR}/parameter_files)
set(_built_without "this program was built without the bounds of limit loads and errors. Build it with CMake's '-DSTRICT_BOUNDS=ON', which needs CHOLMOD and OpenMP, or choose 'Analysis = contact'")
foreach(_way --validate --overwrite)
  add_message_test(limit_load${_way} 2 "entry 'Analysis' is 'limit load', but ${_built_without}"
    ${_cases}/limit_load/strip_punch.prm --output-directory limit_load ${_way})
  add_message_test(limit_load_in_space${_way} 2 "entry 'Analysis' is 'limit load', but ${_built_without}"
    ${_cases}/limit_load/square_punch_3d.prm --output-directory limit_load_in_space ${_way})
  add_message_test(error_bound${_way} 2 "entry 'Analysis' is 'contact with error bound', but ${_built_without}"
    ${_cases}/error_bound/parabola.prm --output-directory error_bound ${_way})
endforeach()
set(_force ${_cases}/verification/strip_punch.prm --overwrite --quiet --output-directory force
  --set "Geometry/Initial refinements=2" --set "Loading/Control=force" --set "Refinement/Number of cycles=1" --set "Output/Fields=never")
add_message_test(force 0 "Warning: This program was built without the bounds of limit loads .CMake's STRICT_BOUNDS.: the force 1 is not compared with them. The load is applied all the same"
  ${_force} --set "Loading/Force=1")
