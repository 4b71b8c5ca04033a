# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later

# add_message_test(<name> <exit status> <message> [argument ...])
#
# Runs the program with the arguments and expects that it ends with the exit
# status and that the regular expression <message> occurs on standard error
# exactly once; blanks in it stand for any white space, and ';' must be written as
# '.'. The tests are called messages/<name> and run on two ranks.
function(add_message_test _name _status _message)
  cmake_parse_arguments(PARSE_ARGV 3 _test "" "" "")
  set(_launcher ${DEAL_II_MPIEXEC} ${DEAL_II_MPIEXEC_NUMPROC_FLAG} 2 ${DEAL_II_MPIEXEC_PREFLAGS})
  add_test(NAME messages/${_name}
    COMMAND ${CMAKE_COMMAND}
      "-DSTATUS=${_status}" "-DMESSAGE=${_message}"
      -P ${CMAKE_CURRENT_SOURCE_DIR}/expect_message.cmake --
      ${_launcher} $<TARGET_FILE:elasto_plastic_contact> ${_test_UNPARSED_ARGUMENTS}
    WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR})
  set_tests_properties(messages/${_name} PROPERTIES LABELS messages TIMEOUT 60)
endfunction()
