# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later

# cmake -DPROGRAM=<program> -DREFERENCE=<file> -DPAGE=<file> -P check_parameters.cmake
#
# Writes the program's own list of parameters to REFERENCE, and fails unless
# PAGE is the same.

include(${CMAKE_CURRENT_LIST_DIR}/write_parameters.cmake)
execute_process(
  COMMAND ${CMAKE_COMMAND} -E compare_files ${REFERENCE} ${PAGE}
  RESULT_VARIABLE _status ERROR_QUIET)
if(NOT _status EQUAL 0)
  message(FATAL_ERROR
    "${PAGE} is not what the program prints (${REFERENCE}).\n"
    "Bring it up to date with the target 'parameters'.")
endif()
