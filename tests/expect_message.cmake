# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later

# cmake -DSTATUS=<exit status> -DMESSAGE=<regular expression> -P expect_message.cmake -- <command> [argument ...]
#
# Fails unless the command ends with STATUS and writes MESSAGE to standard
# error exactly once.

set(_command)
set(_collecting FALSE)
math(EXPR _last "${CMAKE_ARGC} - 1")
foreach(_i RANGE ${_last})
  if(_collecting)
    string(REPLACE ";" "\\;" _argument "${CMAKE_ARGV${_i}}")
    list(APPEND _command "${_argument}")
  elseif("${CMAKE_ARGV${_i}}" STREQUAL "--")
    set(_collecting TRUE)
  endif()
endforeach()

execute_process(COMMAND ${_command}
  RESULT_VARIABLE _status OUTPUT_VARIABLE _output ERROR_VARIABLE _error)

# Long messages are broken into lines at any blank.
string(REGEX REPLACE "[ \n]+" " " _words "${_error}")
string(REPLACE ";" "," _words "${_words}")
string(REGEX MATCHALL "${MESSAGE}" _matches "${_words}")
list(LENGTH _matches _n_matches)

if(NOT "${_status}" STREQUAL "${STATUS}" OR NOT _n_matches EQUAL 1)
  message(FATAL_ERROR
    "Exit status: ${_status}, expected ${STATUS}\n"
    "The message '${MESSAGE}' was found ${_n_matches} times, expected once.\n"
    "Standard error:\n${_error}\nStandard output:\n${_output}")
endif()
