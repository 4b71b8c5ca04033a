# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later

# Sets TRILINOS_SOLVERS to OFF, and says so, where deal.II has been configured without
# the packages of Trilinos that source/solver/matrix_preconditioner_trilinos.cc takes:
# Epetra, Amesos with MUMPS, and ML, of which Trilinos 17 has none.

set(_missing)
if(NOT DEAL_II_WITH_TRILINOS)
  set(_missing Trilinos)
else()
  # (DEAL_II_INCLUDE_DIRS is empty from version 9.5 on.)
  set(_folders ${DEAL_II_INCLUDE_DIRS})
  foreach(_target dealii::dealii_release dealii::dealii_debug)
    if(TARGET ${_target})
      get_target_property(_of_target ${_target} INTERFACE_INCLUDE_DIRECTORIES)
      list(APPEND _folders ${_of_target})
    endif()
  endforeach()
  foreach(_header Epetra_CrsMatrix.h Amesos_Mumps.h ml_MultiLevelPreconditioner.h)
    find_path(_folder_of_header ${_header} HINTS ${_folders} PATHS /usr/include/trilinos)
    if(NOT _folder_of_header)
      list(APPEND _missing ${_header})
    endif()
    unset(_folder_of_header CACHE)
  endforeach()
endif()

if(_missing)
  string(REPLACE ";" ", " _missing "${_missing}")
  message(STATUS "Without Trilinos' solvers (${_missing} not found): there is no algebraic multigrid, "
    "and the direct solver is that of one process (UMFPACK).")
  set(TRILINOS_SOLVERS OFF)
endif()
