# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later

# What `cmake --install` puts where. The program and epc find the ready cases, the parts
# and the Python package relative to themselves, so that the whole may be moved.

install(TARGETS elasto_plastic_contact RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
if(PACKAGE_PROCESSORS)
  set(_parts ${CMAKE_INSTALL_LIBDIR}/elasto_plastic_contact)
  install(TARGETS elasto_plastic_contact_parts DESTINATION ${_parts})
  foreach(_processor ${PACKAGE_PROCESSORS})
    install(TARGETS elasto_plastic_contact_parts_${_processor} DESTINATION ${_parts}/glibc-hwcaps/${_processor})
  endforeach()
  set_target_properties(elasto_plastic_contact PROPERTIES INSTALL_RPATH "$ORIGIN/../${_parts}")
endif()
# (The system's own libraries are found.)
if(NOT DEAL_II_PATH MATCHES "^/usr/?$")
  set_target_properties(${PARTS_LIBRARIES} elasto_plastic_contact PROPERTIES INSTALL_RPATH_USE_LINK_PATH ON)
endif()

# Debian's python3 looks there, if the prefix is /usr.
install(PROGRAMS ${CMAKE_SOURCE_DIR}/scripts/epc DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY ${CMAKE_SOURCE_DIR}/python/elasto_plastic_contact DESTINATION lib/python3/dist-packages
  FILES_MATCHING PATTERN *.py PATTERN *.json PATTERN __pycache__ EXCLUDE)

install(DIRECTORY ${CMAKE_SOURCE_DIR}/parameter_files DESTINATION ${CMAKE_INSTALL_DATADIR}/elasto_plastic_contact
  FILES_MATCHING PATTERN *.prm PATTERN *.msh PATTERN *.geo PATTERN *.pgm PATTERN *.json PATTERN *.csv)

# (in the folders of the checkout, for the links between them)
set(_pages ${CMAKE_INSTALL_DATADIR}/doc/elasto-plastic-contact)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/doc DESTINATION ${_pages}
  FILES_MATCHING PATTERN *.md PATTERN *.png PATTERN *.svg PATTERN references.bib)
# (which pages for developers explain)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/include ${CMAKE_SOURCE_DIR}/source DESTINATION ${_pages}
  FILES_MATCHING PATTERN *.h PATTERN *.cc PATTERN *.in)
install(FILES ${CMAKE_SOURCE_DIR}/python/elasto_plastic_contact/parameters.schema.json
  DESTINATION ${_pages}/python/elasto_plastic_contact)
install(FILES ${CMAKE_SOURCE_DIR}/README.md ${CMAKE_SOURCE_DIR}/LICENSE ${CMAKE_SOURCE_DIR}/CITATION.cff
  DESTINATION ${_pages})
file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/installed)
file(CREATE_LINK ../../elasto_plastic_contact/parameter_files ${CMAKE_BINARY_DIR}/installed/parameter_files SYMBOLIC)
install(FILES ${CMAKE_BINARY_DIR}/installed/parameter_files DESTINATION ${_pages})

foreach(_command elasto_plastic_contact epc)
  install(FILES ${CMAKE_SOURCE_DIR}/scripts/completion/elasto_plastic_contact
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME ${_command})
endforeach()
