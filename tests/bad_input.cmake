# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later

# Every error a user can make, one line each: name, exit status, what standard
# error must say, arguments of the program. See message_test.cmake.
set(_default ${CMAKE_SOURCE_DIR}/parameter_files/sphere_3d.prm)

# Command line
add_message_test(missing_file 2 "does_not_exist\\.prm" does_not_exist.prm)
add_message_test(unknown_option 2 "--no-such-option" ${_default} --no-such-option)

# Parameters
add_message_test(unknown_section 2 "the section .No such section., which does not exist" ${_default} --validate --set "No such section/Entry=1")
add_message_test(unknown_entry 2 "Refinement/No such entry" ${_default} --validate --set "Refinement/No such entry=1")
