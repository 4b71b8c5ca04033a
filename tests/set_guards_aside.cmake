# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later

# deal.II takes a guard file for the sign of an interrupted test, whose program it
# builds again, unless the file has been set aside as at the end of a test.
file(GLOB _guards ${FOLDER}/*/interrupt_guard.cc)
foreach(_guard ${_guards})
  file(RENAME ${_guard} ${_guard}_bck)
endforeach()
