# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later

# `cpack -G DEB` makes a Debian package of what `cmake --install` installs.

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME elasto-plastic-contact)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "elasto-plastic bodies in contact with a rigid indenter")
set(CPACK_PACKAGE_DESCRIPTION
"Presses a rigid indenter into an elasto-plastic body, in two and three
dimensions and on many processors, and finds displacement, stress, plastic
zone, contact zone and contact pressure with finite elements on meshes that
refine themselves. Also limit loads between two rigorous bounds, and
guaranteed error bounds. Based on deal.II.")
set(CPACK_STRIP_FILES ON)

# Who makes a package for others gives an address where problems can be reported.
file(STRINGS ${CMAKE_SOURCE_DIR}/CITATION.cff _authors REGEX "^  - name: ")
string(REGEX REPLACE ".*\"(.*)\"" "\\1" _authors "${_authors}")
set(PACKAGE_MAINTAINER "${_authors} <nobody@elasto-plastic-contact.invalid>" CACHE STRING
  "Name and address in the Debian package")
set(CPACK_PACKAGE_CONTACT ${PACKAGE_MAINTAINER})
set(CPACK_DEBIAN_PACKAGE_MAINTAINER ${PACKAGE_MAINTAINER})

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PARTS_FOLDER})
# What epc fit needs.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3-scipy")
# Of spreadsheets and HDF5 that instruments write.
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "python3-h5py, python3-openpyxl, python3-xlrd")
set(CPACK_DEBIAN_PACKAGE_DEPENDS "mpi-default-bin, python3:any (>= 3.11), python3-matplotlib, python3-numpy")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA
  ${CMAKE_SOURCE_DIR}/cmake/package/postinst ${CMAKE_SOURCE_DIR}/cmake/package/prerm)
# Debian's own packages have these permissions, whatever the umask.
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

# What only a package of Debian has. The date of its changelog is that of
# SOURCE_DATE_EPOCH, if it is set.
set(_debian ${CMAKE_BINARY_DIR}/installed/debian)
set(_debian_pages ${_debian}/doc/elasto-plastic-contact)
string(TIMESTAMP _date "%a, %d %b %Y %H:%M:%S +0000" UTC)
configure_file(${CMAKE_SOURCE_DIR}/cmake/package/changelog.in ${_debian_pages}/changelog.Debian @ONLY)
execute_process(COMMAND gzip -9 --force --no-name ${_debian_pages}/changelog.Debian RESULT_VARIABLE _status)
if(NOT _status EQUAL 0)
  message(STATUS "The program gzip does not work (${_status}): cpack will make no proper package of Debian.")
endif()
configure_file(${CMAKE_SOURCE_DIR}/cmake/package/copyright ${_debian_pages}/copyright COPYONLY)
configure_file(${CMAKE_SOURCE_DIR}/cmake/package/lintian-overrides
  ${_debian}/lintian/overrides/elasto-plastic-contact COPYONLY)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALLED_DIRECTORIES ${_debian} /usr/share)

include(CPack)
