# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later

# cmake -DBUILD=<folder> -DTARGET=<what has to be built> -DPREFIX=<folder> -P installed.cmake
#
# Installs the program into an empty folder and uses it from another one: ready cases,
# epc, manual pages, completion, the links of the pages.

set(_work ${PREFIX}.work)
set(_links ${PREFIX}.links)
file(REMOVE_RECURSE ${PREFIX} ${_work} ${_links})
file(MAKE_DIRECTORY ${_work} ${_links})
set(_path $ENV{PATH})
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

foreach(_program elasto_plastic_contact epc)
  file(CREATE_LINK ${PREFIX}/bin/${_program} ${_links}/${_program} SYMBOLIC)
endforeach()

# (as it may be unpacked by hand, or linked to)
foreach(_folder ${_links} ${PREFIX}/bin)
  set(ENV{PATH} "${_folder}:${_path}")
  expect("indentation/sphere_axisymmetric.prm +[A-Z]" elasto_plastic_contact --list-cases)
  expect("COMMAND.*evaluate +hardness.*fit +the material" epc --help)
  expect("\"Material/Yield stress\"" epc schema)
  expect("steel-4340: AISI 4340" epc new --list-materials)
endforeach()

expect_proposals("Material/Yield\\\\ stress=" _elasto_plastic_contact elasto_plastic_contact --set Material/Y)
expect_proposals("--output-directory" _elasto_plastic_contact elasto_plastic_contact --out)
expect_proposals("indentation/cone_axisymmetric.prm" _elasto_plastic_contact elasto_plastic_contact indentation/cone_a)
expect_proposals("^sphere_axisymmetric\n$" _elasto_plastic_contact elasto_plastic_contact sphere_axisymm)
# (not strip_punch, which is the name of two cases)
expect_proposals("^strip_punch_rolled\n$" _elasto_plastic_contact elasto_plastic_contact strip_pun)
expect_proposals("evaluate" _epc epc ev)
expect_proposals("^fit\n$" _epc epc fi)
expect_proposals("^report\n$" _epc epc rep)
expect_proposals("^coarser\n$" _epc epc report --mesh-pair coa)
expect_proposals("^--help\n$" _epc epc --h)
expect_proposals("^berkovich\n$" _epc epc new ber)
expect_proposals("^aluminium-6061\n$" _epc epc new cone --material aluminium-6)

expect("" elasto_plastic_contact indentation/sphere_axisymmetric.prm --output-directory run
  --set "Loading/Number of steps=2" --set "Geometry/Local refinements=2")
expect("" /usr/bin/python3 ${CMAKE_CURRENT_LIST_DIR}/installed_links.py ${PREFIX}/share/doc/elasto-plastic-contact)

execute_process(COMMAND /usr/bin/python3 -c "import matplotlib" RESULT_VARIABLE _has_no_matplotlib OUTPUT_QUIET ERROR_QUIET)
if(NOT _has_no_matplotlib)
  expect("force_depth.png" epc plot run)
  expect("run/report.html" epc report run)
  expect_proposals("--prog" _epc epc run --p)
  # expect_name(<page> <pattern>): of the line of NAME
  function(expect_name _page _pattern)
    expect("${_pattern}" bash -c "zcat '${PREFIX}/share/man/man1/${_page}.1.gz' | grep -A 1 '^.SH NAME'")
  endfunction()
  expect_name(elasto_plastic_contact " presses a rigid indenter into an elasto[^ ]*plastic body\n$")
  expect_name(epc " run, draw and evaluate what elasto_plastic_contact computes\n$")
  expect("usage: epc run " epc run --help)
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
