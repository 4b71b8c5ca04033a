# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later

# add_message_test(<name> <exit status> <message> [argument ...])
#
# Runs the program with the arguments and expects that it ends with the exit
# status and that the regular expression <message> fits one message on standard error,
# which begins with 'Error: ' or 'Warning: ', and no other; blanks in it stand for any
# white space, and ';' must be written as '.', in arguments as '@'. An error is never beside another.
#
# Starting MPI takes longer than to be refused: the functions write a table, and
# messages.cc runs all of it in one process, or rather in one on each rank.
set(_table ${CMAKE_CURRENT_BINARY_DIR}/messages.txt)
file(WRITE ${_table} "")

function(add_message_test _name _status _message)
  cmake_parse_arguments(PARSE_ARGV 3 _test "" "" "")
  set(_row "name ${_name}\nstatus ${_status}\nmessage ${_message}\n")
  foreach(_argument IN LISTS _test_UNPARSED_ARGUMENTS)
    string(REPLACE "@" ";" _argument "${_argument}")
    string(APPEND _row "argument ${_argument}\n")
  endforeach()
  file(APPEND ${_table} "${_row}")
endfunction()

# add_table_test(<number of ranks> [--reverse])
function(add_table_test _n_ranks)
  add_test(NAME messages.mpirun=${_n_ranks}
    COMMAND ${DEAL_II_MPIEXEC} ${DEAL_II_MPIEXEC_NUMPROC_FLAG} ${_n_ranks} ${DEAL_II_MPIEXEC_PREFLAGS}
      $<TARGET_FILE:messages> ${_table} messages.mpirun=${_n_ranks} ${ARGN}
    WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR})
  set_tests_properties(messages.mpirun=${_n_ranks} PROPERTIES LABELS messages TIMEOUT 600)
endfunction()

add_table_test(1)
add_table_test(2 --reverse)
