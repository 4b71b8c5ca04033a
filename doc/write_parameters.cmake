# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later

# cmake -DPROGRAM=<program> -DREFERENCE=<file> -P write_parameters.cmake
#
# Writes the program's own list of parameters into a Markdown page.

execute_process(COMMAND ${PROGRAM} --print-parameters
  RESULT_VARIABLE _status OUTPUT_VARIABLE _parameters ERROR_VARIABLE _error)
if(NOT _status EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} --print-parameters failed:\n${_error}")
endif()

file(WRITE ${REFERENCE}
  "# Parameters\n\n"
  "Every entry with its meaning, unit, allowed values and default, as printed by\n"
  "`elasto_plastic_contact --print-parameters`.\n\n"
  "```\n${_parameters}```\n")
