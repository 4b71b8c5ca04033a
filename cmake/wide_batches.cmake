# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later

# Sets WIDE_BATCHES_WORK: whether the program of the folder wide_batches compiles, links,
# and finds the right products. Tried again when what it depends on has changed.

set(_tried "${DEAL_II_PACKAGE_VERSION} ${CMAKE_CXX_COMPILER} ${CMAKE_CXX_COMPILER_VERSION} ${PROCESSOR_FLAGS}")
if(NOT "${WIDE_BATCHES_TRIED}" STREQUAL "${_tried}")
  message(STATUS "Trying batches for the processor's widest SIMD instructions")
  set(_folder ${CMAKE_BINARY_DIR}/wide_batches)
  file(REMOVE ${_folder}/wide_batches)
  try_compile(_compiles ${_folder} ${CMAKE_CURRENT_LIST_DIR}/wide_batches wide_batches
    CMAKE_FLAGS -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}
      -Ddeal.II_DIR=${deal.II_DIR} -DPROCESSOR_FLAGS=${PROCESSOR_FLAGS}
    OUTPUT_VARIABLE _output)
  unset(_compiles CACHE)
  set(_status "not run")
  if(EXISTS ${_folder}/wide_batches)
    execute_process(COMMAND ${_folder}/wide_batches
      RESULT_VARIABLE _status OUTPUT_VARIABLE _answer ERROR_VARIABLE _answer)
  endif()
  file(WRITE ${_folder}/output.txt "${_output}${_answer}exit status: ${_status}\n")
  if(_status EQUAL 0)
    set(WIDE_BATCHES_WORK ON CACHE INTERNAL "")
  else()
    message(STATUS "They do not work with deal.II ${DEAL_II_PACKAGE_VERSION}, whose own are taken (${_folder}/output.txt)")
    set(WIDE_BATCHES_WORK OFF CACHE INTERNAL "")
  endif()
  set(WIDE_BATCHES_TRIED "${_tried}" CACHE INTERNAL "")
endif()
