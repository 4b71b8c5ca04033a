# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later

# cmake -DPROGRAM=<program> -DREFERENCE=<file> -P write_parameters.cmake
#
# Writes the program's own list of parameters, a page in Markdown.

execute_process(COMMAND ${PROGRAM} --print-parameters
  RESULT_VARIABLE _status OUTPUT_FILE ${REFERENCE} ERROR_VARIABLE _error)
if(NOT _status EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} --print-parameters failed:\n${_error}")
endif()
