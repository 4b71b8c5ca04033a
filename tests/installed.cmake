# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later

# cmake -DBUILD=<folder> -DTARGET=<what has to be built> -DPREFIX=<folder> -P installed.cmake
#
# Installs the program into an empty folder and uses it from another one: ready cases,
# epc, manual pages, completion.

set(_work ${PREFIX}.work)
file(REMOVE_RECURSE ${PREFIX} ${_work})
file(MAKE_DIRECTORY ${_work})
# (as it may be unpacked by hand)
set(ENV{PATH} "${PREFIX}/bin:$ENV{PATH}")
set(ENV{ELASTO_PLASTIC_CONTACT} "")
set(ENV{PYTHONPATH} "")

# expect(<pattern of the output> <command> [<argument> ...])
function(expect _pattern)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${_work}
    RESULT_VARIABLE _status OUTPUT_VARIABLE _output ERROR_VARIABLE _error)
  string(REPLACE ";" " " _command "${ARGN}")
  if(NOT _status EQUAL 0)
    message(SEND_ERROR "${_command}\nends with ${_status}:\n${_output}${_error}")
  elseif(NOT _output MATCHES "${_pattern}")
    message(SEND_ERROR "${_command}\nprints, instead of '${_pattern}':\n${_output}${_error}")
  endif()
endfunction()

# expect_proposals(<pattern> <function> <word> ...): of the completion, for the last word
function(expect_proposals _pattern _function)
  string(REPLACE ";" "' '" _words "${ARGN}")
  list(LENGTH ARGN _n)
  math(EXPR _last "${_n} - 1")
  list(GET ARGN ${_last} _typed)
  expect("${_pattern}" bash -c
    "source '${PREFIX}/share/bash-completion/completions/epc'
COMP_WORDS=('${_words}') COMP_CWORD=${_last}
${_function} x '${_typed}'
printf '%s\n' \"\${COMPREPLY[@]}\"")
endfunction()

expect("" ${CMAKE_COMMAND} --build ${BUILD} --target ${TARGET})
expect("" ${CMAKE_COMMAND} --install ${BUILD} --prefix ${PREFIX})

expect("indentation/sphere_axisymmetric.prm +[A-Z]" elasto_plastic_contact --list-cases)
expect("" elasto_plastic_contact indentation/sphere_axisymmetric.prm --output-directory run
  --set "Loading/Number of steps=2" --set "Geometry/Local refinements=2")
expect("COMMAND.*evaluate +hardness" epc --help)
expect("\"Material/Yield stress\"" epc schema)

expect_proposals("Material/Yield\\\\ stress=" _elasto_plastic_contact elasto_plastic_contact --set Material/Y)
expect_proposals("--output-directory" _elasto_plastic_contact elasto_plastic_contact --out)
expect_proposals("indentation/cone_axisymmetric.prm" _elasto_plastic_contact elasto_plastic_contact indentation/cone_a)
expect_proposals("evaluate" _epc epc ev)
expect_proposals("--prog" _epc epc run --p)

execute_process(COMMAND /usr/bin/python3 -c "import matplotlib" RESULT_VARIABLE _has_no_matplotlib OUTPUT_QUIET ERROR_QUIET)
if(NOT _has_no_matplotlib)
  expect("force_depth.png" epc plot run)
  find_program(MAN man)
  foreach(_page elasto_plastic_contact epc)
    if(MAN)
      execute_process(COMMAND ${MAN} --warnings -l ${PREFIX}/share/man/man1/${_page}.1.gz
        OUTPUT_QUIET ERROR_VARIABLE _warnings RESULT_VARIABLE _status)
      if(_warnings OR NOT _status EQUAL 0)
        message(SEND_ERROR "man ${_page}: ${_warnings}")
      endif()
    endif()
  endforeach()
endif()
