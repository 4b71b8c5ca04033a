# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later

# try_wide_batches(<result> [<flag of the processor> ...])
#
# Sets <result>: whether the program of the folder wide_batches compiles, links, and finds
# the right products. Tried again when what it depends on has changed, or when the trial
# has been cut short: by a signal, as where memory runs out. (On a processor that is not
# the one of the flags, it need not run.)
function(try_wide_batches _result)
  string(MAKE_C_IDENTIFIER "WIDE_BATCHES${ARGN}" _name)
  set(_tried "${DEAL_II_PACKAGE_VERSION} ${CMAKE_CXX_COMPILER} ${CMAKE_CXX_COMPILER_VERSION}")
  if(NOT "${${_name}_TRIED}" STREQUAL "${_tried}")
    message(STATUS "Trying batches for the widest SIMD instructions (${CMAKE_SYSTEM_PROCESSOR} ${ARGN})")
    set(_folder ${CMAKE_BINARY_DIR}/wide_batches/${_name})
    file(REMOVE ${_folder}/wide_batches)
    try_compile(_compiles ${_folder} ${PROJECT_SOURCE_DIR}/cmake/wide_batches wide_batches
      CMAKE_FLAGS -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}
        -Ddeal.II_DIR=${deal.II_DIR} "-DPROCESSOR_FLAGS=${ARGN}"
      OUTPUT_VARIABLE _output)
    unset(_compiles CACHE)
    set(_status "not run")
    if(EXISTS ${_folder}/wide_batches)
      execute_process(COMMAND ${_folder}/wide_batches
        RESULT_VARIABLE _status OUTPUT_VARIABLE _answer ERROR_VARIABLE _answer)
    endif()
    file(WRITE ${_folder}/output.txt "${_output}${_answer}exit status: ${_status}\n")
    set(${_name}_TRIED "${_tried}" CACHE INTERNAL "")
    if(_status STREQUAL "0" OR _status MATCHES "[Ii]llegal instruction")
      set(${_name} ON CACHE INTERNAL "")
    elseif("${_output}${_status}" MATCHES
        "signal terminated|stopped: interrupted|(:|]|Child) ([Kk]illed|[Tt]erminated|Interrupt)")
      message(WARNING "The trial was cut short (${_folder}/output.txt): deal.II's batches are taken, with which the program is "
        "slower. Run cmake again to repeat it.")
      set(${_name} OFF CACHE INTERNAL "")
      unset(${_name}_TRIED CACHE)
    else()
      message(STATUS "They do not work with deal.II ${DEAL_II_PACKAGE_VERSION}, whose own are taken (${_folder}/output.txt)")
      set(${_name} OFF CACHE INTERNAL "")
    endif()
  endif()
  set(${_result} ${${_name}} PARENT_SCOPE)
endfunction()
