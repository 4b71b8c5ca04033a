# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later

# Every error a user can make, one line each: name, exit status, what standard
# error must say, arguments of the program. See message_test.cmake. Most tests
# take the same small problem and spoil a single entry of it.
set(_files ${CMAKE_CURRENT_SOURCE_DIR}/bad_input)
set(_base ${_files}/base.prm)

# add_entry_test(<name> <message> <Section/Entry=value> ...)
function(add_entry_test _name _message)
  set(_overrides)
  foreach(_override ${ARGN})
    list(APPEND _overrides --set ${_override})
  endforeach()
  add_message_test(${_name} 2 "^Error: .*base.prm: .*${_message}" ${_base} --validate ${_overrides})
endfunction()

# add_file_test(<name of a file in bad_input/> <message>)
function(add_file_test _name _message)
  add_message_test(file_${_name} 2 "^Error: .*${_name}.prm.*${_message}" ${_files}/${_name}.prm --validate)
endfunction()

# Command line
add_message_test(no_file 2 "^Error: Wrong usage: give exactly one parameter file \\(0 given\\)")
add_message_test(two_files 2 "exactly one parameter file \\(2 given\\)" ${_base} ${_base})
add_message_test(unknown_option 2 "unrecognised option '--no-such-option'" ${_base} --no-such-option)
add_message_test(option_without_value 2 "argument for option '--set' is missing" ${_base} --set)
add_message_test(option_with_value 2 "'--validate' does not take any arguments" ${_base} --validate=yes)
add_message_test(option_twice 2 "'--output-directory' cannot be specified more than once" ${_base} --output-directory a --output-directory b)
add_message_test(set_without_value 2 "--set 'Dimension' does not have the form" ${_base} --set Dimension)
add_message_test(set_without_entry 2 "--set '=2' does not have the form" ${_base} --set =2)
add_message_test(set_unknown_section 2 "no section for the entry 'No such section/Entry'" ${_base} --set "No such section/Entry=1")
add_message_test(set_empty_section 2 "no section for the entry '/Dimension'" ${_base} --set /Dimension=2)
add_message_test(set_unknown_entry 2 "no entry 'Refinement/No such entry'.*--print-parameters" ${_base} --set "Refinement/No such entry=1")
add_message_test(set_other_section 2 "no entry 'Material/Radius'. Did you mean '(Geometry|Indenter)/Radius'" ${_base} --set "Material/Radius=1")
add_message_test(set_misspelt_section 2 "no section for the entry 'Materials/Law'. Did you mean 'Material/Law'" ${_base} --set "Materials/Law=x")
add_message_test(set_small_letters 2 "no entry 'Refinement/number of cycle'. Did you mean 'Refinement/Number of cycles'" ${_base} --set "Refinement/number of cycle=1")
add_message_test(set_nothing_similar 2 "no entry 'Refinement/Colour'. All sections and entries" ${_base} --set "Refinement/Colour=1")
add_message_test(set_section 2 "no entry 'Geometry'" ${_base} --set "Geometry=box")

# Limit load
add_entry_test(limit_load_hardening "entry 'Analysis' is 'limit load', but only a body of perfectly plastic materials" "Analysis=limit load")
add_entry_test(goal_analysis "entry 'Refinement/Goal' is 'force', but only 'Analysis = contact with error bound' bounds the force" "Refinement/Goal=force")
add_entry_test(goal_strategy "entry 'Refinement/Goal' is 'force', but only 'Refinement/Strategy = adaptive' has a goal" "Refinement/Goal=force" Refinement/Strategy=Kelly)
add_entry_test(error_bound_history "entry 'Analysis' is 'contact with error bound', but .*one step from the virgin state" "Analysis=contact with error bound" "Loading/Number of steps=2")
add_message_test(error_bound_nonlinear 2 "entry 'Analysis' is 'contact with error bound', but .*linear hardening only" ${CMAKE_SOURCE_DIR}/parameter_files/cylinder_2d.prm --validate --set "Analysis=contact with error bound" --set "Material/Law=nonlinear hardening" --set "Material/Voce stress=100" --set "Material/Voce rate=10")
add_message_test(limit_load_no_indenter 2 "entry 'Indenter/Type' is 'none', but .*largest force of an indenter" ${CMAKE_SOURCE_DIR}/parameter_files/limit_load/strip_punch.prm --validate --set "Indenter/Type=none")
add_message_test(limit_load_quadratic_in_space 2 "entry 'Limit load/Stresses' is 'quadratic', but stresses in space are linear" ${CMAKE_SOURCE_DIR}/parameter_files/limit_load/square_punch_3d.prm --validate --set "Limit load/Stresses=quadratic")
add_message_test(limit_load_resume 2 "nothing to resume. Leave out --resume" ${CMAKE_SOURCE_DIR}/parameter_files/limit_load/strip_punch.prm --resume)

# Soil
set(_soil ${CMAKE_SOURCE_DIR}/parameter_files/limit_load/footing.prm --validate --set)
add_message_test(soil_cohesion 2 "entry 'Material/Cohesion' is '0', but it must be greater than 0: without cohesion, stresses at a free surface" ${_soil} "Material/Cohesion=0")
add_message_test(soil_angle 2 "entry 'Material/Friction angle' is '61', but it must be 0, or lie between 0.1 and 60 degrees" ${_soil} "Material/Friction angle=61")
add_message_test(soil_small_angle 2 "entry 'Material/Friction angle' is '0.09', but it must be 0, or lie between 0.1 and 60 degrees: with less friction" ${_soil} "Material/Friction angle=0.09")
add_message_test(soil_number_of_values 2 "entry 'Material/Friction angle' has 2 values, but another entry of this section has 3" ${_soil} "Material/Cohesion=1, 2, 3" --set "Material/Friction angle=10, 20")
add_message_test(soil_law 2 "entry 'Analysis' is 'limit load', but only a body of perfectly plastic materials" ${_soil} "Material/Law=linear elastic")
add_message_test(soil_analysis 2 "entry 'Material/Yield criterion' is 'Mohr-Coulomb', but 'Mohr-Coulomb' is for limit loads" ${_soil} "Analysis=contact")
add_message_test(soil_error_bound 2 "'Mohr-Coulomb' is for limit loads. Set 'Analysis = limit load'" ${_soil} "Analysis=contact with error bound")
add_message_test(soil_revolution 2 "'Mohr-Coulomb' is for plane strain. Set 'Dimension = 2' and 'Kinematics = plane strain'" ${_soil} "Kinematics=axisymmetric")
add_message_test(soil_plane_stress 2 "'Mohr-Coulomb' is for plane strain" ${_soil} "Kinematics=plane stress")
add_message_test(soil_space 2 "'Mohr-Coulomb' is for plane strain.*in space or in a body of revolution 'Drucker-Prager'" ${CMAKE_SOURCE_DIR}/parameter_files/limit_load/square_punch_3d.prm --validate --set "Material/Yield criterion=Mohr-Coulomb")
set(_cone ${CMAKE_SOURCE_DIR}/parameter_files/limit_load/footing_circular.prm --validate --set)
add_message_test(cone_analysis 2 "entry 'Material/Yield criterion' is 'Drucker-Prager', but 'Drucker-Prager' is for limit loads. Set 'Analysis = limit load'" ${_cone} "Analysis=contact")
add_message_test(cone_plane_strain 2 "'Drucker-Prager' is for bodies of revolution and for bodies in space. Set 'Kinematics = axisymmetric' or 'Dimension = 3'.*in plane strain 'Mohr-Coulomb', which bears the same there" ${_soil} "Material/Yield criterion=Drucker-Prager")
add_message_test(cone_plane_stress 2 "'Drucker-Prager' is for bodies of revolution and for bodies in space" ${_cone} "Kinematics=plane stress")
add_message_test(cone_and_wedge 2 "'Mohr-Coulomb' is for plane strain.*in a body of revolution 'Drucker-Prager'" ${_cone} "Material/Yield criterion=Drucker-Prager, Mohr-Coulomb")
add_message_test(cone_linear_stresses 2 "entry 'Limit load/Stresses' is 'linear', but beside a 'Body force', bodies of revolution whose strength grows with the pressure need 'quadratic'" ${_cone} "Limit load/Stresses=linear" --set "Body force=0; -1")
add_message_test(cone_normal 2 "on soil .'Material/Yield criterion = Drucker-Prager'. indenters press vertically" ${_cone} "Contact/Geometry=normal")
add_message_test(soil_normal 2 "entry 'Contact/Geometry' is 'normal', but on soil .*indenters press vertically" ${_soil} "Contact/Geometry=normal")
set(_full_width ${CMAKE_SOURCE_DIR}/parameter_files/limit_load/strip_punch.prm --quiet --overwrite
  --set "Indenter/Half width=10" --set "Boundary conditions/Free=" --set "Boundary conditions/Fixed=bottom, right")
add_message_test(limit_load_enclosed 3 "There is no limit load: the supports enclose the body, which bears any load, or the indenter reaches a point that is held. Let .Indenter/Reach. end before" ${_full_width} --output-directory limit_load_enclosed)
add_message_test(limit_load_held_point 3 "No velocity moves the whole indenter down: it reaches a point that is held" ${_full_width} --output-directory limit_load_held_point --set "Kinematics=plane stress")
add_message_test(limit_load_tractions 4 "No stresses on this mesh bear the constant loads alone, those in 'Boundary conditions/Traction' and 'Body force'" ${_files}/pulled_apart.prm --quiet --overwrite --output-directory limit_load_tractions)

# What LimitLoadAnalysis::check() lists, before anything is computed
set(_limit_load ${CMAKE_SOURCE_DIR}/parameter_files/limit_load)
set(_loaded_block_in_space ${_limit_load}/square_punch_3d.prm --validate --set "Boundary conditions/Free=back" --set)
add_message_test(limit_load_beside 2 "Error: .*strip_punch.prm: The indenter can never touch the body: no part of the contact boundary lies within its reach. Check 'Indenter/Position'"
  ${_limit_load}/strip_punch.prm --validate --set Indenter/Position=100)
add_message_test(limit_load_beside_in_space 2 "The indenter can never touch the body: no part of the contact boundary" ${_limit_load}/square_punch_3d.prm --validate --set "Indenter/Position=100, 0")
add_message_test(limit_load_within_side 0 "Warning: The indenter reaches parts of sides of the first mesh only. Stresses press where it reaches a whole side, and the lower bound is zero" ${_limit_load}/strip_punch.prm --validate --set "Indenter/Half width=0.05" --set Indenter/Position=0.31)
add_message_test(limit_load_rough_slope 2 "entry 'Indenter/Surface' is 'rough', but the bounds of a rough indenter are for contact boundaries that are level" ${_limit_load}/conical_pit.prm --validate --set Indenter/Surface=rough)
add_message_test(limit_load_tractions_in_space 2 "A traction or displacement of 'Boundary conditions' is not linear on the faces of the mesh" ${_loaded_block_in_space} "Boundary conditions/Traction=right: 0.1*y^2@ 0@ 0")
add_message_test(limit_load_waves_in_space 2 "A traction or displacement of 'Boundary conditions' is not linear on the faces of the mesh" ${_loaded_block_in_space} "Boundary conditions/Traction=right: 0.1*sin(8*pi*y)@ 0@ 0")
add_message_test(limit_load_unsupported 2 "The supports do not hold the body: nothing prevents its rigid body motion 'translation along y'" ${_limit_load}/strip_punch.prm --validate --set "Boundary conditions/Fixed=" --set "Boundary conditions/Free=right, bottom")
add_message_test(limit_load_unsupported_in_space 2 "The supports do not hold the body: nothing prevents its rigid body motion 'translation along z'" ${_limit_load}/square_punch_3d.prm --validate --set "Boundary conditions/Fixed=" --set "Boundary conditions/Free=right, back, bottom")
add_message_test(limit_load_huge_stress 2 "entry 'Material/Yield stress' is '1e.300', but" ${_limit_load}/strip_punch.prm --validate --set "Material/Yield stress=1e300")

set(_pulled_block ${_files}/pulled_apart.prm --quiet --overwrite --set "Limit load/Load=tractions")
add_message_test(limit_load_pulled_away 2 "The supports do not hold the body: nothing prevents its rigid body motion 'translation along x'" ${_pulled_block} --validate --set "Boundary conditions/Roller=" --set "Boundary conditions/Fixed=" --set "Boundary conditions/Contact=" --set Indenter/Type=none --set "Boundary conditions/Free=left, bottom, top")
add_message_test(traction_jumps 2 "The tractions of 'Boundary conditions/Traction' do not fit stresses of the equilibrium method on the side of the mesh from .*: there they must be polynomials of degree 1. Put jumps and kinks on vertices of the mesh" ${_pulled_block} --validate --set "Boundary conditions/Traction=right: if(y < 0.3, t, 0)@ 0")
add_message_test(no_growing_load 2 "entry 'Limit load/Load' is 'tractions', but there is no traction" ${_pulled_block} --validate --set "Boundary conditions/Traction=right: 0@ 0")
add_message_test(load_not_linear 2 "entry 'Limit load/Load' is 'tractions', but tractions and body forces must be linear functions of the time t" ${_pulled_block} --validate --set "Boundary conditions/Traction=right: t^2@ 0")
add_message_test(load_waves_in_time 2 "entry 'Limit load/Load' is 'tractions', but tractions and body forces must be linear functions of the time t" ${_pulled_block} --validate --set "Boundary conditions/Traction=right: t + sin(2*pi*t)@ 0")
add_message_test(body_force_waves 2 "The body force .'Body force'. depends on the position. The equilibrium method is for constant ones" ${_pulled_block} --validate --set "Body force=1 + 0.5*sin(128*pi*x)@ 0")
add_message_test(body_force_by_position 2 "The body force .'Body force'. depends on the position. The equilibrium method is for constant ones" ${_pulled_block} --validate --set "Body force=x@ 0")
add_message_test(negative_load_factor 0 "Warning: The load factor is negative: the body does not bear the tractions and body forces that are constant" ${_pulled_block} --output-directory negative_load_factor
  --set "Boundary conditions/Traction=right: 2 + t@ 0" --set Refinement/Strategy=global)
add_message_test(limit_load_curved 0 "Warning: The boundary of the body is curved. Its bounds are those of the polygon" ${_limit_load}/plate_with_hole.prm --validate)

# Guaranteed error bounds
set(_parabola ${CMAKE_SOURCE_DIR}/parameter_files/error_bound/parabola.prm --validate --set "Material/Law=linear elastic" --set "Boundary conditions/Free=right" --set Loading/Control=depth --set Loading/Depth=0.01)
add_message_test(error_bound_waves 2 "A displacement of 'Boundary conditions/Prescribed displacement' is not quadratic on the sides of the mesh, near the point .-1, "
  ${_parabola} --set "Boundary conditions/Prescribed displacement=left: 3e-2*sin(32*pi*y)@ free")
add_message_test(error_bound_traction_jumps 2 "The tractions of 'Boundary conditions/Traction' do not fit stresses of the equilibrium method on the side of the mesh from .*: there they must be polynomials of degree 1"
  ${_parabola} --set "Boundary conditions/Free=left" --set "Boundary conditions/Traction=right: if(y < -0.7, 1e-3, 0)@ 0")
add_entry_test(contact_bottom "The boundary 'bottom' of 'Boundary conditions/Contact' does not face the indenter, which comes from above" "Boundary conditions/Contact=top, bottom" "Boundary conditions/Fixed=")
add_entry_test(contact_right "The boundary 'right' of 'Boundary conditions/Contact' does not face the indenter, which comes from above" "Boundary conditions/Contact=top, right" "Boundary conditions/Free=")
add_message_test(no_limit_of_loads 3 "There is no limit load: the supports enclose the body, which bears any load" ${_pulled_block} --output-directory no_limit_of_loads --set "Boundary conditions/Fixed=bottom, left, top" --set "Boundary conditions/Roller=" --set "Boundary conditions/Contact=" --set Indenter/Type=none --set "Boundary conditions/Traction=right: -t@ 0" --set "Body force=1@ 0")
add_entry_test(body_force_trailing "entry 'Body force' is '0. 1.', but number 3 of the parts that '.' separates is empty" "Body force=0@ 1@")
add_entry_test(body_force_components "entry 'Body force' is '1', but it must have 2 components separated by ';', one per dimension" "Body force=1")
add_entry_test(body_force_error_bound "entry 'Body force' is '0. 1', but 'Analysis = contact with error bound' knows no body forces. Leave it empty" "Analysis=contact with error bound" "Body force=0@ 1")
add_entry_test(body_force_of_sheet "entry 'Body force' is '0. 1', but 'Analysis = limit load' knows no body forces in plane stress" "Analysis=limit load" "Kinematics=plane stress" "Body force=0@ 1")

# Finite strains
add_entry_test(limit_load_finite "entry 'Strain' is 'logarithmic', but 'Analysis = limit load' is for small strains" "Analysis=limit load" Strain=logarithmic)
add_entry_test(error_bound_normal "entry 'Contact/Geometry' is 'normal', but 'Analysis = contact with error bound' knows the vertical gap only" "Analysis=contact with error bound" Contact/Geometry=normal)
add_entry_test(limit_load_normal_3d "entry 'Contact/Geometry' is 'normal', but 'Analysis = limit load' knows the vertical gap only, but for limit loads in plane strain and of bodies of revolution" "Analysis=limit load" Dimension=3 Contact/Geometry=normal)
add_entry_test(finite_vertical "entry 'Contact/Geometry' is 'vertical', but 'Strain = logarithmic' needs the indenter where the surface is now" Strain=logarithmic Contact/Geometry=vertical)
add_entry_test(finite_normal "entry 'Contact/Geometry' is 'normal', but 'Strain = logarithmic' needs the indenter where the surface is now" Strain=logarithmic Contact/Geometry=normal)
add_entry_test(small_present "entry 'Contact/Geometry' is 'present', but with 'Strain = small' the force would be less than half" Contact/Geometry=present)
# (a quarter of the body as wide, with cells of the same size)
set(_cone ${CMAKE_SOURCE_DIR}/parameter_files/indentation/cone_finite_strain.prm --quiet --overwrite --set "Output/Fields=never"
  --set "Geometry/Lower corner=0, -2" --set "Geometry/Upper corner=2, 0" --set "Geometry/Initial refinements=3"
  --set "Geometry/Local refinements=6" --set "Loading/History=1: depth 0.1" --set "Loading/Maximum number of cuts=0")
add_message_test(finite_too_far 3 "turns elements inside out.*Shorter load steps|with finite strains there is no convex energy.*Shorter load steps" ${_cone} --output-directory finite_too_far --set "Loading/Number of steps=2")
add_message_test(shortest_step_fails 3 "Error: Load step [2-9] from t = 0.[0-9]+ .depth 0.0[0-9]+. fails even if it ends at t = 0.[0-9]+, and 'Loading/Maximum number of cuts' allows for no shorter one. The .*Shorter load steps"
  ${_cone} --output-directory shortest_step_fails --set "Geometry/Local refinements=5" --set "Geometry/Local radius=1" --set "Loading/Number of steps=5")
add_message_test(element_inside_out 0 "Warning: In step [0-9]+ .t = 0.[0-9]+, depth 0.[0-9]+. an element has a corner that is turned inside out, at .[0-9.]+, -?[0-9.e-]+. of the deformed body. its scaled Jacobian is -[0-9.e-]+. .*hardly depend on them"
  ${_cone} --output-directory element_inside_out --set "Contact/Edge=at nodes" --set "Geometry/Local radius=1" --set "Indenter/Semi-apex angle=45" --set "Loading/History=1: depth 0.08" --set "Loading/Number of steps=32" --set "Loading/Maximum number of cuts=6")

# Adaptive load steps
add_entry_test(adaptive_single_step "entry 'Loading/Step control' is 'adaptive', but a single step is Johnson's stationary problem" "Loading/Step control=adaptive")

# Two-step integration
add_entry_test(bdf2_recovery "entry 'Loading/Integration' is 'BDF2', but back stresses that recover .'Material/Recovery rates'. follow their law exactly in backward Euler steps only" Loading/Integration=BDF2 "Loading/Number of steps=4"
  "Material/Law=nonlinear hardening" "Material/Back stress moduli=2000" "Material/Recovery rates=10")

# Friction and motion to the side
add_entry_test(friction_negative "entry 'Contact/Friction coefficient' is '-0.1', but it must be a number, at least 0, or 'stick'" "Contact/Friction coefficient=-0.1")
add_entry_test(friction_word "entry 'Contact/Friction coefficient' is 'rough', but it must be a number, at least 0, or 'stick'" "Contact/Friction coefficient=rough")
add_entry_test(rough_indenter "entry 'Indenter/Surface' is 'rough', but that is for 'Analysis = limit load'" "Indenter/Surface=rough" Dimension=2)
add_entry_test(friction_limit_load "entry 'Contact/Friction coefficient' is '0.1', but 'Analysis = limit load' knows indenters without friction" "Analysis=limit load" "Contact/Friction coefficient=0.1" Dimension=2)
add_entry_test(path_row "entry 'Loading/Path' is '2 0.1', but a row must look like" "Loading/Path=1: 0, 0 | 2 0.1")
add_entry_test(path_number "entry 'Loading/Path' is '1: a, 0', but a row must look like" "Loading/Path=1: a, 0")
add_entry_test(path_times "entry 'Loading/Path' is '1: 1, 0', but the times must increase" "Loading/Path=1: 0, 0 | 1: 1, 0")
add_entry_test(path_rows_differ "entry 'Loading/Path' is '1: 0, 0 | 2: 1', but all rows must have the same number of components" "Loading/Path=1: 0, 0 | 2: 1")
add_entry_test(path_three "entry 'Loading/Path' is '1: 0, 0, 0', but the indenter moves in one direction in the plane, in two in space" "Loading/Path=1: 0, 0, 0")
add_message_test(path_space 2 "entry 'Loading/Path' is '1: 0.1', but in three dimensions the indenter moves along x and y" ${CMAKE_SOURCE_DIR}/parameter_files/sphere_3d.prm --validate --set "Loading/Path=1: 0.1")
add_entry_test(path_plane "entry 'Loading/Path' is 't. t', but in two dimensions the indenter moves along x only" "Loading/Path=t@ t" Dimension=2)
add_entry_test(path_start "entry 'Loading/Path' is '1 .+ t. t', but at t = 0 the indenter is at 'Indenter/Position'" "Loading/Path=1 + t@ t")
add_entry_test(path_expression "entry 'Loading/Path' is 'sin.*" "Loading/Path=sin(@ t")
add_message_test(path_symmetry 2 "entry 'Loading/Path' is '2: 0, 0.1', but the indenter stands on a plane of symmetry across y" ${CMAKE_SOURCE_DIR}/parameter_files/sphere_3d.prm --validate --set "Loading/Path=2: 0, 0.1")
add_message_test(path_over_the_edge 2 "entry 'Loading/Path' is '2: 0 . 4: 100', but at t = 2.4 the indenter comes to the edge of the contact boundary, or is beyond it" ${CMAKE_SOURCE_DIR}/parameter_files/friction/mindlin_cylinder.prm --validate --set "Loading/History=1: force 836.8 | 2: force 0 | 4: force 0" --set "Loading/Path=2: 0 | 4: 100")
add_message_test(path_over_the_edge_in_space 2 "entry 'Loading/Path' is '2: 10, 0', but at t = .* the indenter comes to the edge of the contact boundary, or is beyond it" ${CMAKE_SOURCE_DIR}/parameter_files/friction/scratch.prm --validate --set "Loading/Path=2: 10, 0")
# (the tip ends a unit before the edge, the ball's contact on it)
add_message_test(path_of_contact_over_the_edge 2 "entry 'Loading/Path' is '2: 7', but at t = 2 the indenter comes to the edge of the contact boundary" ${_base} --validate --set "Geometry/Lower corner=-8, -8" --set "Geometry/Upper corner=8, 0" --set Indenter/Radius=8 --set "Boundary conditions/Roller=" --set "Boundary conditions/Free=left, right" --set "Loading/History=1: depth 0.1 | 2: depth 0.1" --set "Loading/Path=2: 7")
add_message_test(path_undefined 2 "entry 'Loading/Path' is .*at t = 0.6 its value is not a number" ${CMAKE_SOURCE_DIR}/parameter_files/friction/mindlin_cylinder.prm --validate --set "Loading/Path=sqrt(0.5 - t) - sqrt(0.5)")
add_message_test(path_no_indenter 2 "entry 'Loading/Path' is '1: 0.1', but there is no indenter" ${CMAKE_SOURCE_DIR}/parameter_files/material/plane_stress_tension.prm --validate --set "Loading/Path=1: 0.1")
add_entry_test(path_axisymmetric "entry 'Loading/Path' is '1: 0.1', but an indenter that moves sideways is not axisymmetric" "Loading/Path=1: 0.1" Dimension=2 Kinematics=axisymmetric)

# Parameter file
add_message_test(file_missing 2 "^Error: There is no parameter file '[^ ]*/does_not_exist.prm', and no ready case 'does_not_exist.prm' in '[^ ]*/parameter_files'. elasto_plastic_contact --list-cases lists" does_not_exist.prm)
add_message_test(case_misspelt 2 "no ready case 'indentation/shpere_3d' in '[^ ]*/parameter_files'. Did you mean 'indentation/sphere_3d.prm'. elasto_plastic_contact --list-cases" indentation/shpere_3d)
add_message_test(case_ambiguous 2 "^Error: The name 'strip_punch' fits several ready cases: 'limit_load/strip_punch.prm', 'verification/strip_punch.prm'. Give one of these" strip_punch)
add_message_test(file_directory 2 "bad_input' does not exist or cannot be read" ${_files})
add_file_test(empty "'Boundary conditions/Contact' is empty")
add_file_test(binary "line 1: This is none of 'set Entry = value'")
add_file_test(not_closed "The section 'Geometry' is not closed: an 'end' is missing. \\([^ ]*not_closed.prm, line 2\\)")
add_file_test(end_missing "line 3: There is no section 'Geometry/Material'. Is the 'end' of the section 'Geometry' missing. \\([^ ]*end_missing.prm, line 1\\)")
add_file_test(closes_outer "line 3: [^ ]*end_only.prm, line 1: This 'end' closes no 'subsection'")
add_file_test(byte_order_mark "line 1: The file begins with a byte order mark, .*UTF-8 without")
add_file_test(utf_16 "line 1: The file is in UTF-16, which some editors call Unicode. Save it as plain text")
add_file_test(utf_16_without_mark "line 1: The file is in UTF-16")
add_file_test(old_mac "line 4: The entry 'Indenter/Radius' is 'small', but it must be: number")
add_message_test(set_twice 0 "^Warning: .*set_twice.prm, line 3: The entry 'Dimension' has been set before .[^ ]*set_twice.prm, line 2.. This line counts. remove one of the two" ${_files}/set_twice.prm --validate)
add_file_test(end_only "line 1: This 'end' closes no 'subsection'")
add_file_test(end_with_name "line 2: After 'end' nothing can follow")
add_file_test(no_equal_sign "line 1: An entry must look like 'set Entry = value'")
add_file_test(include "line 1: The file '[^ ]*bad_input/no_such_file.prm' to be included does not exist .*in the folder of the file that includes it")
add_file_test(braces "line 1: The entry 'Dimension' is '\\{2\\}', but it must be: integer from 2 to 3")
add_file_test(unknown_section "line 2: There is no section 'Geometri'. Did you mean 'Geometry'. All .*--print-parameters")
add_file_test(unknown_entry "line 3: There is no entry 'Geometry/Typ'. Did you mean 'Geometry/Type'. All .*--print-parameters")
add_file_test(wrong_value "line 4: The entry 'Material/Yield stress' is 'high', but it must be: list.*number")

# However long they are.
set(_here ${CMAKE_CURRENT_BINARY_DIR})
string(REPEAT "x" 100000 _long)
file(WRITE ${_here}/long_line.prm "${_long}\n")
file(WRITE ${_here}/long_value.prm "set Dimension = ${_long}\n")
file(WRITE ${_here}/long_expression.prm "include ${_base}\nsubsection Loading\n set Depth = ${_long}\nend\n")
file(WRITE ${_here}/long_history.prm "include ${_base}\nsubsection Loading\n set History = ${_long}\nend\n")
file(WRITE ${_here}/include_itself.prm "# twice\ninclude ${_here}/include_itself_too.prm\n")
file(WRITE ${_here}/include_itself_too.prm "include ${_here}/./include_itself.prm\n")
add_message_test(long_line 2 "^Error: [^ ]*long_line.prm, line 1: This is none of" ${_here}/long_line.prm --validate)
add_message_test(long_value 2 "^Error: [^ ]*long_value.prm, line 1: The entry 'Dimension' is 'x+...', but it must be: integer from 2 to 3" ${_here}/long_value.prm --validate)
add_message_test(long_expression 2 "^Error: [^ ]*long_expression.prm: The entry 'Loading/Depth' is 'x+...', but this is not an expression" ${_here}/long_expression.prm --validate)
add_message_test(long_history 2 "^Error: [^ ]*long_history.prm: The entry 'Loading/History' is 'x+...', but a row must look like" ${_here}/long_history.prm --validate)
add_message_test(include_itself 2 "^Error: [^ ]*include_itself.prm, line 2: [^ ]*include_itself_too.prm, line 1: The file '[^ ]*include_itself.prm' is included while it is being read" ${_here}/include_itself.prm --validate)

# parameters.prm could not say these; but a value may be in any 8-bit code.
string(ASCII 7 _bell)
add_message_test(value_with_comment 2 "'Output/Directory' is 'run#1', but a value cannot contain '#'" ${_base} --validate --output-directory run\#1)
add_message_test(value_with_backslash 2 "'Output/Directory' is 'C:.', but a value cannot .* end with a backslash" ${_base} --validate --output-directory "C:\\")
add_entry_test(output_directory_empty "'Output/Directory' is '', but it must name a folder" "Output/Directory=")
add_entry_test(unit_in_brackets "'Output/Length unit' is '<mm>', but a unit is a name such as mm" "Output/Length unit=<mm>")
add_message_test(unknown_field 2 "'Output/Additional fields' is 'temperature', but it must be: list.*`principal stresses`" ${_base} --validate --set "Output/Additional fields=temperature")
add_message_test(value_with_bell 2 "'Output/Directory' is 'a.b', but a value cannot contain .* a control character" ${_base} --validate --output-directory "a${_bell}b")
string(ASCII 233 _e_acute)
file(WRITE ${_here}/latin_1.prm "include ${_base}\nsubsection Output\n set Directory = r${_e_acute}sultats\nend\nsubsection Indenter\n set Radius = 0\nend\n")
add_message_test(latin_1 2 "^Error: [^ ]*latin_1.prm: The entry 'Indenter/Radius' is '0'" ${_here}/latin_1.prm --validate)

# Values that are not of the right kind
add_message_test(dimension 2 "'Dimension' is '4', but it must be: integer from 2 to 3" ${_base} --set Dimension=4)
add_message_test(no_number 2 "'Dimension' is 'two', but" ${_base} --set Dimension=two)
add_message_test(n_faces 2 "'Indenter/Number of faces' is '2', but it must be: integer >= 3" ${_base} --set "Indenter/Number of faces=2")
add_message_test(fraction 2 "'Discretization/Polynomial degree' is '1.5', but it must be: integer from 1 to 2" ${_base} --set "Discretization/Polynomial degree=1.5")
add_message_test(nan 2 "'Indenter/Radius' is 'nan', but it must be: number" ${_base} --set Indenter/Radius=nan)
add_message_test(infinity 2 "'Loading/Depth' is 'inf', but it must be finite" ${_base} --set Loading/Depth=inf)
add_message_test(huge_number 2 "'Loading/Depth' is '1e999', but this is not an expression in t that can be evaluated" ${_base} --set Loading/Depth=1e999)
add_message_test(empty_value 2 "'Material/Yield stress' is '', but it must be: list" ${_base} --set "Material/Yield stress=")
add_message_test(unknown_choice 2 "'Linear solver/Type' is 'gmres', but it must be: .*AMG.*direct" ${_base} --set "Linear solver/Type=gmres")
if(NOT TRILINOS_SOLVERS)
  add_message_test(no_algebraic_multigrid 2 "'Linear solver/Type' is 'AMG', but this program has been built without Trilinos' ML.*'multigrid' or 'direct'" ${_base} --set "Linear solver/Type=AMG")
endif()
add_message_test(too_many_cuts 2 "'Loading/Maximum number of cuts' is '31', but it must be" ${_base} --set "Loading/Maximum number of cuts=31")
add_message_test(too_many_steps 2 "'Loading/Number of steps' is '2147483647', but it must be: integer from 1 to 1000000" ${_base} --validate --set "Loading/Number of steps=2147483647")
add_message_test(no_steps 2 "'Loading/Number of steps' is '0', but it must be" ${_base} --set "Loading/Number of steps=0")

# Material
add_entry_test(negative_modulus "'Material/Young's modulus' is '-1', but it must be greater than 0" "Material/Young's modulus=-1")
add_entry_test(incompressible "'Material/Poisson's ratio' is '0.5', but it must lie between -1 and 0.5" "Material/Poisson's ratio=0.5")
add_entry_test(zero_yield_stress "'Material/Yield stress' is '0', but it must be greater than 0" "Material/Yield stress=0")
foreach(_modulus 0 1e300 2e40 2e-60)
  add_entry_test(extreme_modulus_${_modulus} "'Material/Young's modulus' is '[0-9e+-]*', but it must be greater than 0, from 1e-30 to 1e30: tangents are kept in single precision" "Material/Young's modulus=${_modulus}" "Material/Law=linear elastic")
endforeach()
add_entry_test(huge_hardening "'Material/Isotropic hardening modulus' is '1e.300', but its numbers must not exceed 1e100" "Material/Isotropic hardening modulus=1e300")
add_entry_test(huge_back_stress "'Material/Back stress moduli' is '1e300', but it must be 'none', or numbers .* at most 1e100" "Material/Back stress moduli=1e300" "Material/Recovery rates=0")
add_entry_test(isotropic_softening "'Material/Isotropic hardening modulus' is '-1', but it must not be negative" "Material/Isotropic hardening modulus=-1")
add_entry_test(kinematic_softening "'Material/Kinematic hardening modulus' is '-1', but it must not be negative" "Material/Kinematic hardening modulus=-1")
add_entry_test(voce_stress "'Material/Voce stress' is '-1', but it must not be negative: softening" "Material/Voce stress=-1")
add_entry_test(voce_rate "'Material/Voce rate' is '-1', but it must be between 0 and 1e12" "Material/Voce rate=-1")
add_entry_test(voce_without_rate "'Material/Voce rate' is '0', but 'Material/Voce stress' is not 0: then the rate must be greater" "Material/Voce stress=1")
add_entry_test(power_law_exponent "'Material/Power law exponent' is '1.1', but it must lie between 0 .* and 1" "Material/Power law exponent=1.1")
add_entry_test(power_law_strain "'Material/Power law reference strain' is '0', but it must be at least 1e-12" "Material/Power law reference strain=0")
add_entry_test(table_format "'Material/Hardening table' is '0.1 500', but it must be 'none', or pairs" "Material/Hardening table=0.1 500")
add_entry_test(or_in_expression "'Geometry/Boundary parts' is '5: x > 0.1 .. y < 0', but .*In an expression, 'or' is max.a, b.: '..' would separate" "Geometry/Boundary parts=5: x > 0.1 || y < 0")
add_entry_test(table_empty "'Material/Hardening table' is '. 0.1: 500', but number 1 of the parts that '.' separates is empty" "Material/Hardening table=| 0.1: 500")
add_entry_test(table_infinite "'Material/Hardening table' is '0.1: inf', but it must be 'none', or pairs" "Material/Hardening table=0.1: inf")
add_entry_test(table_origin "'Material/Hardening table' is '0: 401', but its strains must increase, and be greater than 0" "Material/Hardening table=0: 401")
add_entry_test(table_strains "'Material/Hardening table' is '0.1: 500 . 0.1: 600', but its strains must increase" "Material/Hardening table=0.1: 500 | 0.1: 600")
add_entry_test(table_jump "'Material/Hardening table' is '1e-307: 450', but its strains must increase, .* Steps below 1e-12 are lost in rounding" "Material/Hardening table=1e-307: 450")
add_entry_test(voce_jump "'Material/Voce rate' is '1e.13', but it must be between 0 and 1e12" "Material/Voce rate=1e13")
add_entry_test(power_law_jump "'Material/Power law reference strain' is '1e-13', but it must be at least 1e-12" "Material/Power law reference strain=1e-13")
add_entry_test(table_stresses "'Material/Hardening table' is '0.1: 500 . 0.2: 499', but its stresses must not decrease" "Material/Hardening table=0.1: 500 | 0.2: 499")
add_entry_test(step_tolerance "'Loading/Step tolerance' is '0', but it must be greater than 0" "Loading/Step tolerance=0")
add_entry_test(rate_exponent "'Material/Rate exponent' is '0.5', but it must lie between 1 .linear viscosity. and 1000" "Material/Rate exponent=0.5")
foreach(_entry "Reference rate" "Rate stress" "Relaxation time")
  string(MAKE_C_IDENTIFIER ${_entry} _name)
  add_entry_test(zero_${_name} "'Material/${_entry}' is '0', but it must be greater than 0" "Material/${_entry}=0")
endforeach()
add_entry_test(rate_of_elastic "'Material/Rate law' is 'Perzyna', but with 'Law = linear elastic' the material does not flow, however fast: choose a law with a yield stress, or 'Norton'" "Material/Law=linear elastic" "Material/Rate law=Perzyna")
add_entry_test(hosford_exponent "'Material/Hosford exponent' is '1.5', but it must lie between 2 .von Mises. and 100" "Material/Hosford exponent=1.5")
add_entry_test(hill_ratios_count "'Material/Hill ratios' is '1 . 1 . 1', but it must be six numbers, R_11 . R_22 . R_33" "Material/Hill ratios=1 | 1 | 1")
add_entry_test(hill_ratios_sign "'Material/Hill ratios' is '1 . 1 . 1 . 1 . 1 . 0', but the ratios must be greater than 0, from 0.01 to 100" "Material/Hill ratios=1 | 1 | 1 | 1 | 1 | 0")
add_entry_test(hill_ratios_convex "'Material/Hill ratios' is '1 . 1 . 0.5 . 1 . 1 . 1', but with these ratios the yield surface would not be closed and convex" "Material/Hill ratios=1 | 1 | 0.5 | 1 | 1 | 1")
add_entry_test(axes_count "'Material/Axes' is '1 . 2', but it must be one angle, about the third axis, or Bunge's three" "Material/Axes=1 | 2")
add_entry_test(axes_expression "'Material/Axes' is '30.x.', but this is not an expression in x,y,z" "Material/Axes=30*x*")
add_entry_test(axes_of_height "'Material/Axes' is '30.z', but this is not an expression in x,y" "Material/Yield criterion=Hill" "Material/Axes=30*z")
add_entry_test(axes_turning_in_plane "'Material/Axes' is '0 . 30.x . 0', but angles that are expressions of the position must be one" "Material/Yield criterion=Hill" "Material/Axes=0 | 30*x | 0")
add_entry_test(axes_without_value "'Material/Axes' is '1/.x-x.', but at .* its value is" "Material/Yield criterion=Hill" "Material/Axes=1/(x-x)")
add_entry_test(axes_list "'Material/Axes' has 2 values, but another entry of this section has 3" "Material/Axes=1, 2" "Material/Yield stress=1, 2, 3")
add_entry_test(criterion_recovery "'Material/Yield criterion' is 'Hill', but with other criteria than that of von Mises back stresses cannot recover" "Material/Yield criterion=Hill" "Material/Law=nonlinear hardening" "Material/Back stress moduli=1000" "Material/Recovery rates=10")
add_entry_test(criterion_plane_stress "'Material/Yield criterion' is 'Hosford', but the strain across a sheet is known for the criterion of von Mises only" "Material/Yield criterion=Hosford" "Kinematics=plane stress" "Discretization/Volumetric treatment=standard")
add_entry_test(criterion_logarithmic "'Material/Yield criterion' is 'Hill', but with 'Strain = logarithmic' Newton's method converges for the criterion of von Mises only" "Material/Yield criterion=Hill" Strain=logarithmic)
add_entry_test(criterion_third_axis "'Material/Axes' is '0 . 30 . 0', but in two dimensions one of the axes of the material must be the third of the body" "Material/Yield criterion=Hill" "Material/Hill ratios=1 | 1.1 | 1 | 1 | 1 | 1" "Material/Axes=0 | 30 | 0")
set(_asymmetric --validate --set "Material/Yield criterion=Hill" --set "Material/Hill ratios=1 | 1.3 | 0.9 | 0.8 | 1 | 1" --set "Material/Axes=10")
add_message_test(criterion_symmetry 2 "The rollers through 'Indenter/Position' make a plane of symmetry of the body, but its material is not symmetric about that" ${CMAKE_SOURCE_DIR}/parameter_files/cylinder_2d.prm ${_asymmetric})
add_message_test(criterion_symmetry_of_sector 2 "The rollers through 'Indenter/Position' make a plane of symmetry of the body, but its material is not symmetric about that" ${CMAKE_SOURCE_DIR}/parameter_files/indentation/vickers_sector.prm ${_asymmetric} --set Strain=small --set "Material/Axes=0")
add_entry_test(criterion_error_bound "'Material/Yield criterion' is 'Hosford', but 'Analysis = contact with error bound' has no bounds for the criterion of Hosford" "Material/Yield criterion=Hosford" "Analysis=contact with error bound")
set(_rolled ${CMAKE_SOURCE_DIR}/parameter_files/limit_load/strip_punch_rolled.prm --validate --set)
add_message_test(criterion_limit_load 2 "'Material/Yield criterion' is 'Hill, Hosford', but 'Analysis = limit load' has no bounds for the criterion of Hosford" ${_rolled} "Material/Yield criterion=Hill, Hosford")
add_message_test(criterion_beside_soil 2 "'Material/Yield criterion' is 'Hill, Mohr-Coulomb', but beside soil, other materials can obey the criterion of von Mises only" ${_rolled} "Material/Yield criterion=Hill, Mohr-Coulomb")
add_message_test(criterion_limit_load_axis 2 "'Material/Axes' is '0 . 30 . 0', but in two dimensions one of the axes of the material must be the third of the body" ${_rolled} "Material/Axes=0 | 30 | 0" --set "Material/Hill ratios=1 | 1.1 | 1 | 1 | 1 | 1")
add_message_test(criterion_limit_load_turning 2 "'Material/Axes' is '30.x', but 'Analysis = limit load' knows axes that are the same everywhere" ${_rolled} "Material/Axes=30*x")
set(_indenter_symmetry 2 "The rollers through 'Indenter/Position' make a plane of symmetry of the body, but the indenter is not symmetric about that")
add_message_test(indenter_symmetry ${_indenter_symmetry} ${CMAKE_SOURCE_DIR}/parameter_files/indentation/vickers_sector.prm --validate --set "Indenter/Number of faces=3" --set "Indenter/Face angle=65.27")
add_message_test(indenter_rotation ${_indenter_symmetry} ${CMAKE_SOURCE_DIR}/parameter_files/indentation/vickers_sector.prm --validate --set Indenter/Rotation=20)
add_message_test(indenter_symmetry_blunt ${_indenter_symmetry} ${CMAKE_SOURCE_DIR}/parameter_files/indentation/vickers_sector.prm --validate --set "Indenter/Number of faces=3" --set "Indenter/Face angle=65.27" --set "Indenter/Rounding radius=0.2")
add_entry_test(indenter_symmetry_plane "the indenter is not symmetric about that" Indenter/Type=expression "Indenter/Expression=0.1*x")
add_message_test(indenter_symmetry_limit_load 2 "the indenter is not symmetric about that" ${CMAKE_SOURCE_DIR}/parameter_files/limit_load/strip_punch.prm --validate --set Indenter/Type=expression --set "Indenter/Expression=0*x+if(x > 0.5, 0.1, 0)")
# (what is symmetric goes on to the next mistake: lowest beside its position; without a value beyond the body)
foreach(_expression "0.05*cos(3*x)" "1.02 - sqrt(1.02^2 - x^2)")
  string(MAKE_C_IDENTIFIER "${_expression}" _name)
  add_entry_test(indenter_symmetric_${_name} "Nothing loads the body" "Geometry/Lower corner=0, -3" "Geometry/Upper corner=1, 0"
    Indenter/Type=expression "Indenter/Expression=${_expression}" Loading/Control=force Loading/Force=0)
endforeach()
add_message_test(criterion_limit_load_symmetry 2 "The rollers through 'Indenter/Position' make a plane of symmetry of the body, but its material is not symmetric about that" ${_rolled} "Material/Axes=10")
add_entry_test(rates_list "'Material/Rate law' has 2 values, but another entry of this section has 3" "Material/Rate law=none, Norton" "Material/Yield stress=1, 2, 3")
add_entry_test(tiny_yield_strain "'Material/Yield stress' is '400', but with 'Material/Young's modulus = 1e[+]15' the material yields at a strain of 4e-13.*same system of units" "Material/Young's modulus=1e15")
foreach(_load Depth=1e-200 "Control=force@Loading/Force=1e-160" "Control=force@Loading/Force=1e-300")
  string(MAKE_C_IDENTIFIER ${_load} _name)
  string(REPLACE "@" ";" _load ${_load})
  add_entry_test(tiny_load_${_name} "The loads are so small that the rounding of numbers hides what they do: .* strains the body by about [0-9.e-]+. At least 1e-20 is needed" Loading/${_load})
endforeach()
add_message_test(tiny_traction_at_first 2 "^Error: .*forces are so small that their squares vanish.*'Loading'.*system of units" ${_base} --quiet --overwrite --output-directory tiny_traction_at_first --set "Boundary conditions/Free=" --set "Boundary conditions/Traction=right: t^600@ 0" --set "Loading/Depth=max(0, t - 0.6)" --set "Loading/Number of steps=2")
add_entry_test(table_start "'Material/Hardening table' is '0.1: 300', but its stresses must not decrease, nor begin below 'Material/Yield stress'" "Material/Hardening table=0.1: 300")
add_entry_test(back_stress_number "'Material/Back stress moduli' is '1000 . x', but it must be 'none', or numbers" "Material/Back stress moduli=1000 | x")
add_entry_test(back_stress_negative "'Material/Back stress moduli' is '-1', but it must be 'none', or numbers that are finite and not negative" "Material/Back stress moduli=-1" "Material/Recovery rates=0")
add_entry_test(back_stress_count "'Material/Back stress moduli' is '1 . 2 . 3 . 4 . 5', but a material can have at most 4 back stresses" "Material/Back stress moduli=1 | 2 | 3 | 4 | 5")
add_entry_test(recovery_negative "'Material/Recovery rates' is '-1', but it must be 'none', or numbers" "Material/Back stress moduli=1" "Material/Recovery rates=-1")
add_entry_test(recovery_count "'Material/Recovery rates' is 'none', but 'Material/Back stress moduli' is '1 . 2': give one rate for each" "Material/Back stress moduli=1 | 2")
add_entry_test(material_lists "'Material/Young's modulus' has 2 values, but another entry of this section has 3" "Material/Young's modulus=1,2" "Material/Yield stress=1,2,3")
add_entry_test(material_id_missing "describe 2 materials, but 'Geometry/Material id' is empty: .* a comma separates two of them" "Material/Yield stress=1,500")
add_entry_test(modulus_with_comma "'Material/Young's modulus' is '1, 0', but .* a comma separates two of them" "Material/Young's modulus=1,000")
add_entry_test(material_id_without_material "has the material id 2, but the entries of 'Material' describe 2 materials: 0 to 1" "Geometry/Material id=if(y < 0.2, 2, 0)" "Material/Yield stress=1,2")
add_entry_test(negative_material_id "'Geometry/Material id' is '-1', but at the centre .* is no number of a material" "Geometry/Material id=-1")
add_entry_test(infinite_material_id "'Geometry/Material id' is .*, but at \\(0.875 .*infinite" "Geometry/Material id=if(x > 0.8, 1/(x-0.875), 0)")

# Box and half ball
add_entry_test(boundary_part_form "'Geometry/Boundary parts' is 'strip: top', but it must look like 'name: boundary. condition'" "Geometry/Boundary parts=strip: top")
add_entry_test(boundary_part_of_nothing "'Geometry/Boundary parts' is .*, but there is no boundary 'lid'. The geometry has: bottom, left, right, top" "Geometry/Boundary parts=strip: lid@ x > 0.5")
add_entry_test(boundary_part_name "'Geometry/Boundary parts' is .*, but the part needs a name that no boundary has" "Geometry/Boundary parts=left: top@ x > 0.5")
add_entry_test(boundary_part_comma "'Geometry/Boundary parts' is .*, but the part needs a name that no boundary has, and without ','" "Geometry/Boundary parts=a, b: top@ x > 0.5")
add_entry_test(boundary_part_within_side "'Geometry/Boundary parts' is .*, but the part ends within a side of a cell of the coarse mesh, near the point \\(.* 1\\)" "Geometry/Boundary parts=strip: top@ x > 0.7")
add_entry_test(boundary_part_nowhere "'Geometry/Boundary parts' is .*, but the condition holds nowhere on 'top'" "Geometry/Boundary parts=strip: top@ x > 2")
add_entry_test(boundary_part_everywhere "'Geometry/Boundary parts' is .*, but the condition holds everywhere on 'top'" "Geometry/Boundary parts=strip: top@ x > -1")
add_entry_test(boundary_part_without_condition "Boundaries without a condition: strip" "Geometry/Repetitions=2" "Geometry/Boundary parts=strip: top@ x > 0.5")
add_entry_test(corner_components "'Geometry/Lower corner' is '0, 0, 0', but it must be empty or have 2 coordinates" "Geometry/Lower corner=0,0,0")
add_entry_test(corners "'Geometry/Upper corner' is '1, 0', but each of its coordinates must be larger" "Geometry/Upper corner=1,0")
add_entry_test(extreme_box "cells without a volume" "Geometry/Upper corner=1e300,1e300")
add_entry_test(no_cells "'Geometry/Repetitions' is '0', but there must be at least one cell" "Geometry/Repetitions=0")
add_entry_test(repetitions_components "'Geometry/Repetitions' is '1, 1, 1', but it must have one number, or one per dimension" "Geometry/Repetitions=1,1,1")
add_entry_test(too_many_coarse_cells "'Geometry/Repetitions' is '100000', but .* more than 1e7 cells" "Geometry/Repetitions=100000")
add_entry_test(too_many_cells "'Geometry/Initial refinements' is '20', but the mesh would have .* cells" "Geometry/Initial refinements=20")
add_entry_test(too_many_local_cells "'Geometry/Local refinements' is '20', but the mesh would have .* cells or more. At most .* are possible here" "Geometry/Local refinements=20" "Geometry/Local radius=1e6")
add_entry_test(grading "'Geometry/Grading' is '0.5', but it must not be less than 1" "Geometry/Grading=0.5")
add_entry_test(grading_centre_components "'Geometry/Grading centre' is '0, 0', but it must be empty or have one coordinate" "Geometry/Grading centre=0,0")
add_entry_test(grading_centre_outside "'Geometry/Grading centre' is '2', but it must lie between" "Geometry/Grading centre=2")
add_entry_test(grading_centre_repetitions "'Geometry/Grading centre' is '0.5', but .* needs at least 2 'Repetitions'" "Geometry/Grading centre=0.5" "Geometry/Repetitions=1")
add_entry_test(circle_2d "'Geometry/Circle radius' is '0.5', but circles are for three dimensions" "Geometry/Circle radius=0.5")
add_entry_test(circle_negative "'Geometry/Circle radius' is '-1', but it must not be negative" Dimension=3 "Geometry/Circle radius=-1")
add_entry_test(circle_centre_components "'Geometry/Circle centre' is '0.5', but it must be empty or have the two coordinates" "Geometry/Circle centre=0.5")
add_entry_test(circle_too_large "'Geometry/Circle radius' is '1', but it must be less than the sides of the cells" Dimension=3 "Geometry/Circle radius=1")
add_entry_test(circle_between_cells "'Geometry/Circle radius' is '0.1', but .*'Circle centre', which must be a corner of cells" Dimension=3 "Geometry/Circle radius=0.1" "Geometry/Circle centre=0.6, 0.5")
add_entry_test(ball_radius "'Geometry/Radius' is '0', but it must be greater than 0" "Geometry/Type=half ball" "Geometry/Radius=0")
add_entry_test(ball_part "'Geometry/Part' is 'quarter', but in two dimensions" "Geometry/Type=half ball" "Geometry/Part=quarter")
add_entry_test(sector_2d "'Geometry/Type' is 'sector', but a sector of a round block needs 'Dimension = 3'" "Geometry/Type=sector")
add_entry_test(sector_radius "'Geometry/Radius' is '0', but it must be greater than 0" Dimension=3 "Geometry/Type=sector" "Geometry/Radius=0")
add_entry_test(sector_angle "'Geometry/Sector angle' is '181', but it must be greater than 0 and at most 180 degrees" Dimension=3 "Geometry/Type=sector" "Geometry/Sector angle=181")
add_entry_test(sector_no_angle "'Geometry/Sector angle' is '0', but it must be greater than 0" Dimension=3 "Geometry/Type=sector" "Geometry/Sector angle=0")
add_entry_test(sector_core "'Geometry/Core radius' is '0.6', but it must be at most half of 'Radius', which is 1" Dimension=3 "Geometry/Type=sector" "Geometry/Core radius=0.6")
add_entry_test(sector_no_core "'Geometry/Core radius' is '0', but .* at least a millionth" Dimension=3 "Geometry/Type=sector" "Geometry/Core radius=0")
add_entry_test(sector_height "'Geometry/Height' is '0.1', but it must be at least twice 'Core radius', which is 0.125" Dimension=3 "Geometry/Type=sector" "Geometry/Height=0.1")
add_entry_test(sector_one_plane "'back'.* front, side, top" Dimension=3 "Geometry/Type=sector" "Geometry/Sector angle=180" "Boundary conditions/Roller=front, back" "Boundary conditions/Fixed=bottom" "Boundary conditions/Free=side")

add_message_test(unused_material 0 "Warning: No cell of the mesh consists of the material 1, .* 'Geometry/Material id'" ${_base} --validate --set "Geometry/Material id=if(y > 0.99, 1, 0)" --set "Material/Yield stress=1,2")

# Mesh files
add_entry_test(mesh_missing "no.msh', but there is no such file" "Geometry/Type=file" "Geometry/File=no.msh")
add_entry_test(mesh_no_mesh "base.prm', but in line 1 of this file '.MeshFormat' is missing" "Geometry/Type=file" "Geometry/File=${_base}")
add_entry_test(mesh_truncated "truncated.msh', but in line .* it ends too early" "Geometry/Type=file" "Geometry/File=${_files}/truncated.msh")
add_entry_test(mesh_byte_order_mark "byte_order_mark.msh', but this file begins with a byte order mark" "Geometry/Type=file" "Geometry/File=${_files}/byte_order_mark.msh")
add_entry_test(mesh_old_mac "old_mac.msh', but in line 21 .* where a whole number should be" "Geometry/Type=file" "Geometry/File=${_files}/old_mac.msh")
add_entry_test(mesh_broken "broken.msh', but in line 21 .* where a whole number should be" "Geometry/Type=file" "Geometry/File=${_files}/broken.msh")
add_entry_test(mesh_of_triangles "triangle.msh', but in line 20 .* there are triangles, but only quadrilaterals" "Geometry/Type=file" "Geometry/File=${_files}/triangle.msh")
add_entry_test(mesh_without_boundary "no_boundary.msh', but no part of its boundary is in a physical group" "Geometry/Type=file" "Geometry/File=${_files}/no_boundary.msh")
add_entry_test(mesh_hanging_node "hanging_node.msh', but the corner \\(1 0.5\\) of a cell lies inside an edge of another one" "Geometry/Type=file" "Geometry/File=${_files}/hanging_node.msh")
add_entry_test(mesh_distorted "distorted.msh', but the cell with the centre \\(0.325 0.325\\) is distorted .*Improve the mesh there" "Geometry/Type=file" "Geometry/File=${_files}/distorted.msh")
set(_square "Geometry/Type=file" "Geometry/File=${_files}/square.msh")
add_entry_test(mesh_material_group "entry 'Geometry/Material groups' is 'steel', but no cell is in a physical group of this name. .* groups: 1." ${_square} "Geometry/Material groups=steel")
add_entry_test(mesh_material_id_and_group "entry 'Geometry/Material id' is '0', but 'Geometry/Material groups' says .*Leave one of them empty" ${_square} "Geometry/Material groups=1" "Geometry/Material id=0")
add_entry_test(mesh_dimension "square.msh', but this mesh is two-dimensional .* while 'Dimension' is 3" "Dimension=3" "Geometry/Type=file" "Geometry/File=${_files}/square.msh")

# Boundary conditions
add_entry_test(boundary_without_condition "Boundaries without a condition: left, right. Name each" "Boundary conditions/Roller=" "Boundary conditions/Free=")
add_entry_test(boundary_with_two_conditions "boundary 'bottom' has two conditions: .*'Boundary conditions/Fixed' and in 'Boundary conditions/Free'" "Boundary conditions/Free=right,bottom")
add_entry_test(unknown_boundary "'Boundary conditions/Free' is 'rihgt', but there is no such boundary. The geometry has: bottom, left, right, top" "Boundary conditions/Free=rihgt")
add_entry_test(boundary_of_3d "'Boundary conditions/Free' is 'back', but there is no such boundary" "Boundary conditions/Free=right,back")
add_entry_test(indenter_without_boundary "'Boundary conditions/Contact' is empty" "Boundary conditions/Contact=" "Boundary conditions/Free=right,top")
add_entry_test(boundary_without_indenter "'Boundary conditions/Contact' names a boundary, but 'Indenter/Type' is 'none'" "Indenter/Type=none")
add_entry_test(traction_without_name "'Boundary conditions/Traction' is 'right', but it must look like 'name: component. component'" "Boundary conditions/Free=" "Boundary conditions/Traction=right")
add_entry_test(traction_components "'Boundary conditions/Traction' is '1', but it must have 2 components" "Boundary conditions/Free=" "Boundary conditions/Traction=right: 1")
add_entry_test(traction_free "a component of a traction cannot be free" "Boundary conditions/Free=" "Boundary conditions/Traction=right: 1@ free")
add_entry_test(traction_expression "'Boundary conditions/Traction' is '2.x.', but this is not an expression in x,y,t" "Boundary conditions/Free=" "Boundary conditions/Traction=right: 2*x+@ 0")
add_entry_test(traction_variable "'Boundary conditions/Traction' is 'z', but this is not an expression in x,y,t" "Boundary conditions/Free=" "Boundary conditions/Traction=right: z@ 0")
add_entry_test(traction_nan "'Boundary conditions/Traction' is 'log.y-0.5.', but at .* its value is not a number" "Boundary conditions/Free=" "Boundary conditions/Traction=right: 0@ log(y-0.5)")
add_entry_test(displacement_infinite "'Boundary conditions/Prescribed displacement' is '1/y', but at .* its value is infinite" "Boundary conditions/Free=" "Boundary conditions/Prescribed displacement=right: 1/y@ free")
add_entry_test(no_support_but_indenter "nothing prevents its rigid body motion 'translation along y'" "Boundary conditions/Fixed=" "Boundary conditions/Roller=left,right" "Boundary conditions/Free=bottom")
add_entry_test(no_support_but_indenter_3d "nothing prevents its rigid body motion 'translation along z'" "Dimension=3" "Boundary conditions/Fixed=" "Boundary conditions/Roller=left,front" "Boundary conditions/Free=bottom,right,back")
add_entry_test(no_support_of_island "nothing prevents its rigid body motion 'translation along x' of the part between \\(3 0\\) and \\(4 1\\)" "Geometry/Type=file" "Geometry/File=${_files}/island.msh" "Boundary conditions/Roller=" "Boundary conditions/Free=0")
add_entry_test(no_support_of_hinged_cell "nothing prevents its rigid body motion 'translation along x' of the part between \\(1 1\\) and \\(2 2\\)" "Geometry/Type=file" "Geometry/File=${_files}/hinge.msh" "Boundary conditions/Roller=" "Boundary conditions/Free=0")
add_entry_test(no_support "supports do not hold the body: nothing prevents its rigid body motion 'translation along x'" "Boundary conditions/Fixed=" "Boundary conditions/Roller=" "Boundary conditions/Free=bottom,left,right")

# Indenter
add_entry_test(radius "'Indenter/Radius' is '0', but it must be greater than 0" "Indenter/Radius=0")
add_entry_test(angle "'Indenter/Semi-apex angle' is '90', but it must lie between 0 and 90 degrees" "Indenter/Semi-apex angle=90")
add_entry_test(half_width "'Indenter/Half width' is '-1', but it must be greater than 0" "Indenter/Half width=-1")
add_entry_test(strip_punch "'Indenter/Half width' is '1, 1', but a strip punch has a single half width" "Indenter/Type=strip punch" "Indenter/Half width=1,1")
add_entry_test(rectangular_punch "'Indenter/Half width' is '1, 1', but in 2 dimensions" "Indenter/Type=rectangular punch" "Indenter/Half width=1,1")
add_entry_test(face_angle "'Indenter/Face angle' is '90', but it must lie between 0 and 90 degrees" "Indenter/Face angle=90")
add_entry_test(rounding_radius "'Indenter/Rounding radius' is '-1', but it must not be negative" "Indenter/Rounding radius=-1")
add_message_test(rotation 2 "'Indenter/Rotation' is '1e.19', but it must lie between -360 and 360 degrees" ${CMAKE_SOURCE_DIR}/parameter_files/sphere_3d.prm --validate --set Indenter/Type=pyramid --set Indenter/Rotation=1e19)
add_entry_test(truncation "'Indenter/Truncation' is '-1', but it must not be negative" "Indenter/Truncation=-1")
add_entry_test(rounded_truncation "'Indenter/Truncation' is '1', but 'Rounding radius' rounds the tip already" "Indenter/Truncation=1" "Indenter/Rounding radius=1")
add_entry_test(plane_pyramid "'Indenter/Type' is 'pyramid', but in two dimensions there are no pyramids. The cone .* 'Semi-apex angle = 70.2996" "Indenter/Type=pyramid")
add_entry_test(area_decreases "'Indenter/Area coefficients' is '24.5, -0.1', but the section of the tip must grow" "Indenter/Type=area function" "Indenter/Area coefficients=24.5, -0.1")
add_entry_test(position_components "'Indenter/Position' is '0, 0', but in 2 dimensions it must be empty or hold one coordinate" "Indenter/Position=0,0")
add_entry_test(initial_gap "'Indenter/Initial gap' is '-1', but it must not be negative" "Indenter/Initial gap=-1")
add_entry_test(reach "'Indenter/Reach' is '-1', but it must not be negative" "Indenter/Reach=-1")
add_entry_test(size "'Indenter/Size' is '0', but it must be greater than 0" "Indenter/Size=0")
add_entry_test(size_components "'Indenter/Size' is '', but in 2 dimensions an image or a height matrix needs one extent" "Indenter/Type=image")
add_entry_test(height_scale "'Indenter/Height scale' is '-1', but it must be greater than 0" "Indenter/Height scale=-1")
add_entry_test(indenter_expression "'Indenter/Expression' is 'x..2', but this is not an expression" "Indenter/Type=expression" "Indenter/Expression=x**2")
add_entry_test(indenter_expression_empty "'Indenter/Expression' is '', but this is not an expression" "Indenter/Type=expression" "Indenter/Expression=")
add_entry_test(indenter_expression_nan "'Indenter/Expression' is 'log.0.6-x.', but at .* its value is not a number" "Indenter/Type=expression" "Indenter/Expression=log(0.6-x)")
add_entry_test(image_missing "no.png', but there is no such file" "Indenter/Type=image" "Indenter/Size=1" "Indenter/File=no.png")
add_entry_test(image_of_wrong_type "base.prm', but its content is neither a PNG nor" "Indenter/Type=image" "Indenter/Size=1" "Indenter/File=${_base}")
add_entry_test(image_truncated "truncated.pgm', but the file ends before its last pixel" "Indenter/Type=image" "Indenter/Size=1" "Indenter/File=${_files}/truncated.pgm")
add_entry_test(image_absurd_header "absurd_header.pgm', but the header of this image promises 999999 x 999999 pixels" "Indenter/Type=image" "Indenter/Size=1" "Indenter/File=${_files}/absurd_header.pgm")
add_entry_test(matrix_no_number "no_number.txt', but number 3 .* is not a finite number" "Indenter/Type=height matrix" "Indenter/Size=1" "Indenter/File=${_files}/no_number.txt")
add_entry_test(matrix_utf_16 "utf_16.txt', but this file is in UTF-16" "Indenter/Type=height matrix" "Indenter/Size=1" "Indenter/File=${_files}/utf_16.txt")
add_entry_test(matrix_old_mac "old_mac.txt', but the row in line 3 has length 2, the ones before it 3" "Indenter/Type=height matrix" "Indenter/Size=1" "Indenter/File=${_files}/old_mac.txt")
add_entry_test(matrix_ragged "ragged.txt', but .* All rows must have the same length" "Indenter/Type=height matrix" "Indenter/Size=1" "Indenter/File=${_files}/ragged.txt")
add_entry_test(matrix_decimal_commas "decimal_commas.txt', but numbers in line 2 are separated by white space, and by commas too. Numbers have a decimal point" "Indenter/Type=height matrix" "Indenter/Size=1" "Indenter/File=${_files}/decimal_commas.txt")
add_entry_test(matrix_decimal_commas_and_blanks "commas_and_blanks.txt', but numbers in line 1 have commas, with and without white space behind them in turn. Numbers have a decimal point" "Indenter/Type=height matrix" "Indenter/Size=1" "Indenter/File=${_files}/commas_and_blanks.txt")
add_entry_test(matrix_decimal_commas_in_column "commas_in_column.txt', but all lines are two numbers without a decimal point, with a comma between them. Numbers have a decimal point" "Indenter/Type=height matrix" "Indenter/Size=1" "Indenter/File=${_files}/commas_in_column.txt")
add_entry_test(matrix_of_points "points.txt', but its rows are the points of a lattice, x y z. A height matrix holds heights only" "Indenter/Type=height matrix" "Indenter/Size=1" "Indenter/File=${_files}/points.txt")
add_entry_test(matrix_two_rows "two_rows.txt', but it has 2 rows" "Indenter/Type=height matrix" "Indenter/Size=1" "Indenter/File=${_files}/two_rows.txt")
add_entry_test(stl_of_wrong_type "base.prm', but its content is not an STL surface" "Indenter/Type=STL surface" "Indenter/File=${_base}")
add_entry_test(stl_byte_order_mark "byte_order_mark.stl', but this file begins with a byte order mark" "Indenter/Type=STL surface" "Indenter/File=${_files}/byte_order_mark.stl")
add_entry_test(stl_truncated "truncated.stl', but line 8 of this STL text should have 'endfacet' here" "Indenter/Type=STL surface" "Indenter/File=${_files}/truncated.stl")
add_entry_test(length_scale "'Indenter/Length scale' is '0', but it must be greater than 0" "Indenter/Length scale=0")
add_entry_test(out_of_reach "indenter can never touch the body: no node" "Indenter/Position=50")
foreach(_narrow "Indenter/Type=strip punch@Indenter/Half width=1e-9" "Indenter/Radius=1e-300" "Indenter/Reach=1e-9")
  string(MAKE_C_IDENTIFIER ${_narrow} _name)
  string(REPLACE "@" ";" _narrow ${_narrow})
  add_entry_test(too_narrow_${_name} "The indenter reaches less than 1e-6 of the size of the body to both sides, which no mesh resolves" ${_narrow})
endforeach()
add_entry_test(through_the_body "'Loading/Depth' is '3', but at the depth 3 the indenter is through the body, whose height is 1" Loading/Depth=3)
add_entry_test(history_through_the_body "'Loading/History' is '1: depth 1e300 . 2: force 0', but at the depth 1e.300 the indenter is through the body" "Loading/History=1: depth 1e300 | 2: force 0")
add_entry_test(too_short "'Loading/Depth' is '0.001', but the indenter can never touch the body: the smallest gap" "Indenter/Initial gap=1")
add_entry_test(depth_of_gap "'Loading/Depth' is '0.25', but the indenter can never touch the body: the smallest gap under it is 0.25" "Indenter/Initial gap=0.25" Loading/Depth=0.25)

# Numbers with a decimal comma, and assignments, in every expression
add_entry_test(expression_of_components "entry 'Loading/Depth' is '0.01.', but a '.' stands between the components of a vector, and this expression has a single value" "Loading/Depth=0.01@")
# The time where nothing can change
add_entry_test(time_in_indenter "'Indenter/Expression' is 'x.2/2-0.01.t', but this is not an expression in x,y that can be evaluated" "Indenter/Type=expression" "Indenter/Expression=x^2/2-0.01*t")
add_entry_test(time_in_material_id "'Geometry/Material id' is 'if.t>1,1,0.', but this is not an expression in x,y that can be evaluated" "Geometry/Material id=if(t>1,1,0)")
add_entry_test(boundary_twice "The boundary 'top' is named twice in 'Boundary conditions/Contact'. Name each boundary once" "Boundary conditions/Contact=top, top")

set(_comma "but a ',' can only stand between the arguments of a function. Numbers have a decimal point: write")
add_entry_test(comma_in_depth "'Loading/Depth' is '0,01', ${_comma} 0.01" "Loading/Depth=0,01")
add_entry_test(comma_in_negative_number "'Body force' is '-10,5', ${_comma} -10.5" "Body force=0@-10,5")
add_entry_test(comma_after_minus "'Loading/Depth' is '1-2,5.t', ${_comma} 2.5" "Loading/Depth=1-2,5*t")
add_entry_test(comma_in_brackets "'Loading/Depth' is '.0,01..t', ${_comma} 0.01" "Loading/Depth=(0,01)*t")
add_entry_test(comma_in_force "'Loading/Force' is '2,5', ${_comma} 2.5" "Loading/Control=force" "Loading/Force=2,5")
add_entry_test(comma_in_traction "'Boundary conditions/Traction' is '0,5', ${_comma} 0.5" "Boundary conditions/Free=" "Boundary conditions/Traction=right: 0,5@ 0")
add_entry_test(comma_in_displacement "'Boundary conditions/Prescribed displacement' is '1,5.t', ${_comma} 1.5" "Boundary conditions/Free=" "Boundary conditions/Prescribed displacement=right: 1,5*t@ free")
add_entry_test(comma_in_material_id "'Geometry/Material id' is '0,1', ${_comma} 0.1" "Geometry/Material id=0,1")
add_entry_test(comma_in_indenter "'Indenter/Expression' is 'x.2/2,5', ${_comma} 2.5" "Indenter/Type=expression" "Indenter/Expression=x^2/2,5")
add_entry_test(comma_in_half_width "'Indenter/Half width' is '1, 5', but .*Numbers have a decimal point" "Indenter/Type=strip punch" "Indenter/Half width=1,5")
add_entry_test(list_for_expression "'Loading/Depth' is 't,t', but a ',' can .*An expression has a single value" "Loading/Depth=t,t")
add_entry_test(assignment_in_depth "'Loading/Depth' is 't=0.5', but a '=' would give a variable another value. Write '=='" "Loading/Depth=t=0.5")
add_entry_test(assignment_in_material_id "'Geometry/Material id' is 'if.x=1,1,0.', but a '=' would" "Geometry/Material id=if(x=1,1,0)")

# What cannot be evaluated at a later time
set(_late "at .*t = 0.8 its value is not a number")
add_entry_test(late_depth "'Loading/Depth' is '0.01.t.log.0.65-t.', but ${_late}" "Loading/Depth=0.01*t+log(0.65-t)" "Loading/Number of steps=5")
add_entry_test(late_traction "'Boundary conditions/Traction' is 'log.0.65-t.', but ${_late}" "Boundary conditions/Free=" "Boundary conditions/Traction=right: log(0.65-t)@ 0" "Loading/Number of steps=5")
add_entry_test(late_displacement "'Boundary conditions/Prescribed displacement' is 'log.0.65-t.', but ${_late}" "Boundary conditions/Free=" "Boundary conditions/Prescribed displacement=right: log(0.65-t)@ free" "Loading/Number of steps=5")

# What fails on one rank only
add_message_test(limit_load_expression_nan 2 "'Indenter/Expression' is 'if.x>0.7,log.0.8-x.,0.', but at .* its value is not a number"
  ${CMAKE_SOURCE_DIR}/parameter_files/limit_load/strip_punch.prm --quiet --overwrite --output-directory limit_load_expression_nan
  --set "Indenter/Type=expression" --set "Indenter/Expression=if(x>0.7,log(0.8-x),0)")
add_message_test(plane_stress_overflow 3 "The forces are no longer finite numbers"
  ${CMAKE_SOURCE_DIR}/parameter_files/cylinder_2d.prm --quiet --overwrite --output-directory plane_stress_overflow
  --set "Kinematics=plane stress" --set "Boundary conditions/Free=" --set "Boundary conditions/Traction=right: 1e300@ 0")

# Kinematics and local refinement
add_entry_test(local_radius "'Geometry/Local radius' is '0', but it must be greater than 0" "Geometry/Local radius=0")
add_entry_test(local_centre "'Geometry/Local centre' is '0', but it must be empty or hold one coordinate for each of the" "Geometry/Local centre=0")
add_entry_test(axisymmetric_3d "'Kinematics' is 'axisymmetric', but that is for two dimensions" "Dimension=3" "Kinematics=axisymmetric")
add_entry_test(plane_stress_3d "'Kinematics' is 'plane stress', but that is for two dimensions" "Dimension=3" "Kinematics=plane stress")
add_entry_test(plane_stress_b_bar "'Discretization/Volumetric treatment' is 'B-bar', but in plane stress" "Kinematics=plane stress" "Discretization/Volumetric treatment=B-bar")
add_message_test(across_the_axis 2 "'Kinematics' is 'axisymmetric', but the body reaches to negative x"
  ${CMAKE_SOURCE_DIR}/parameter_files/indentation/sphere_axisymmetric.prm --validate --set "Geometry/Lower corner=-1, -4")

# Loading, refinement and solvers
add_entry_test(depth "'Loading/Depth' is '0', but it must be greater than 0" "Loading/Depth=0")
add_entry_test(depth_expression "'Loading/Depth' is '0.1.x', but this is not an expression in t that can be evaluated" "Loading/Depth=0.1*x")
add_entry_test(depth_not_finite "'Loading/Depth' is '0.001/.t-0.5.', but at t = 0.5 its value is infinite" "Loading/Depth=0.001/(t-0.5)" "Loading/Number of steps=2")
add_entry_test(never_deep_enough "'Loading/Depth' is '0.1.t', but the indenter can never touch the body" "Loading/Depth=0.1*t" "Indenter/Initial gap=1")
foreach(_depth -t 0*t -0.1*sin\(pi*t\))
  string(MAKE_C_IDENTIFIER ${_depth} _name)
  add_entry_test(no_depth_${_name} "Nothing loads the body: at the ends of all load steps, neither depth nor force of the indenter is greater than 0" Loading/Depth=${_depth} "Loading/Number of steps=2")
endforeach()
add_entry_test(negative_force "'Loading/Force' is '-1', but a force cannot be negative" "Loading/Control=force" "Loading/Force=-1")
add_entry_test(force_below_zero "'Loading/Force' is 'at t = 1: -0.5', but a force cannot be negative" "Loading/Control=force" "Loading/Force=t-1.5")
add_entry_test(hold_first "'Loading/History' is '1: hold', but a row must look like .* or, but for the first, '3: hold'" "Loading/History=1: hold | 2: depth 0.1")
add_entry_test(final_time "'Loading/Final time' is '0', but it must be a number greater than 0" "Loading/Final time=0")
add_entry_test(history_row "'Loading/History' is '1 depth 0.1', but a row must look like" "Loading/History=1 depth 0.1")
add_entry_test(history_word "'Loading/History' is '2: load 1', but a row must look like" "Loading/History=1: depth 0.1 | 2: load 1")
add_entry_test(history_number "'Loading/History' is '1: depth deep', but a row must look like" "Loading/History=1: depth deep")
add_entry_test(history_not_finite "'Loading/History' is '1: depth nan', but its numbers must be finite" "Loading/History=1: depth nan")
add_entry_test(history_not_increasing "'Loading/History' is '1: force 0', but the times must increase" "Loading/History=1: depth 0.1 | 1: force 0")
add_entry_test(history_from_zero "'Loading/History' is '0: depth 0', but the times must increase, and the first must be greater than 0" "Loading/History=0: depth 0 | 1: depth 1")
add_entry_test(history_negative_force "'Loading/History' is '1: force -2', but a force cannot be negative" "Loading/History=1: force -2")
add_entry_test(history_negative_force_rate "'Loading/History' is '2: force rate -2', but a force cannot be negative" "Loading/History=1: force 1 | 2: force rate -2")
add_entry_test(history_strain_rate_first "'Loading/History' is '1: strain rate 0.1', but a strain rate is a part of the depth per time, and the depth there is 0" "Loading/History=1: strain rate 0.1")
add_entry_test(history_strain_rate_word "'Loading/History' is '2: strain speed 1', but a row must look like .*'3: strain rate 0.05'" "Loading/History=1: depth 0.1 | 2: strain speed 1")
add_entry_test(history_strain_rate_too_large "'Loading/History' is '2: strain rate 1e4', but it leads to no finite load" "Loading/History=1: depth 0.1 | 2: strain rate 1e4")
add_entry_test(history_never_touches "'Loading/History' is '1: depth 0.1', but the indenter can never touch" "Loading/History=1: depth 0.1" "Indenter/Initial gap=1")
add_entry_test(history_without_push "'Loading/History' is '1: depth 0.1 . 2: force 0', but the indenter can never touch" "Loading/History=1: depth 0.1 | 2: force 0" "Indenter/Initial gap=1")
add_entry_test(cycles_without_strategy "'Refinement/Number of cycles' is '2', but 'Refinement/Strategy = none' allows one" "Refinement/Strategy=none" "Refinement/Number of cycles=2")
add_entry_test(fractions "'Refinement/Coarsening fraction' is '0.6', but together with" "Refinement/Refinement fraction=0.6" "Refinement/Coarsening fraction=0.6")
add_entry_test(tolerance "'Nonlinear solver/Tolerance' is '1', but it must lie between 1e-14 and 1e-2" "Nonlinear solver/Tolerance=1")
add_entry_test(loosest_linear_reduction "'Nonlinear solver/Loosest linear reduction' is '1', but it must lie between 1e-12 and 0.5" "Nonlinear solver/Loosest linear reduction=1")
add_entry_test(adaptation_global "'Refinement/Steps between adaptations' is '2', but only 'Refinement/Strategy = adaptive' can" Refinement/Strategy=global "Refinement/Steps between adaptations=2")
add_message_test(resume_and_overwrite 2 "--overwrite begins anew, --resume goes on" ${_base} --resume --overwrite)
add_message_test(nothing_to_resume 2 "base.prm: There is nothing to resume: 'nothing_to_resume/checkpoint' does not exist" ${_base} --output-directory nothing_to_resume --resume)
add_message_test(validate_nothing_to_resume 2 "base.prm: There is nothing to resume: 'nothing_to_resume/checkpoint' does not exist" ${_base} --validate --output-directory nothing_to_resume --resume)
add_message_test(validate_resume_damaged 2 "The checkpoint '.*interrupted/checkpoint' is damaged" ${_base} --validate --output-directory ${_files}/interrupted --resume)
add_message_test(first_mesh_too_fine 2 "'Refinement/Maximum number of unknowns' is '10', but the first mesh has 32 unknowns or more" ${_base} --output-directory first_mesh_too_fine --overwrite --set "Refinement/Maximum number of unknowns=10")
add_message_test(validate_first_mesh_too_fine 2 "but the first mesh has 8396802 unknowns or more" ${_base} --validate --set "Geometry/Initial refinements=9" --set "Refinement/Maximum number of unknowns=1000000")
add_message_test(no_convergence 3 "has not converged in 1 iterations" ${_base} --output-directory no_convergence --overwrite --set "Nonlinear solver/Maximum number of iterations=1" --set Loading/Depth=0.1)
add_message_test(overflow 3 "forces are no longer finite numbers" ${_base} --output-directory overflow --overwrite --set "Boundary conditions/Free=" --set "Boundary conditions/Traction=right: 1e300@ 0")

# Each of these is said once, although all later steps are beyond the limit, too.
add_message_test(residual_of_rounding 0 "Warning: The forces on the free unknowns are up to 1e-09 of all forces, above 'Nonlinear solver/Tolerance': .* this is said again only if they grow tenfold"
  ${CMAKE_SOURCE_DIR}/parameter_files/creep/thick_cylinder.prm --overwrite --quiet --output-directory residual_of_rounding --set "Material/Rate law=none" --set "Material/Poisson's ratio=0.4999"
  --set "Geometry/Initial refinements=1" --set "Discretization/Polynomial degree=2" --set "Loading/Final time=0.01" --set "Loading/Number of steps=4")
add_message_test(large_plastic_strain 0 "^Warning: Step 3 leaves the theory of small strains: the largest equivalent plastic strain is 0.147 .limit: 0.1.. What follows"
  ${CMAKE_SOURCE_DIR}/parameter_files/material/uniaxial_isotropic.prm --overwrite --quiet --output-directory large_plastic_strain
  --set "Boundary conditions/Prescribed displacement=top: free; free; 0.2*t" --set "Loading/Final time=1" --set "Loading/Number of steps=4")
set(_elastic_indentation ${CMAKE_SOURCE_DIR}/parameter_files/verification/hertz_axisymmetric.prm --overwrite --quiet
  --set "Loading/Control=depth" --set "Loading/Number of steps=3" --set "Geometry/Initial refinements=3")
add_message_test(tip_between_nodes 0 "Warning: The indenter is in the body, between the nodes that could touch it, and meets no resistance: the mesh is too coarse under its tip. Set 'Geometry/Local refinements', or take more load steps if"
  ${_elastic_indentation} --output-directory tip_between_nodes --set "Loading/History=1: depth 0.0004 | 2: depth 0.0009" --set "Indenter/Radius=100" --set "Geometry/Local refinements=0" --set "Discretization/Polynomial degree=2" --set "Discretization/Volumetric treatment=standard")
add_message_test(pressure_of_thin_layer 0 "Warning: Step 1: the contact pressure at .0, 0. is [0-9.]+, more than a large body with this yield stress can bear .9.55[0-9] at most.. In a thin layer"
  ${CMAKE_SOURCE_DIR}/parameter_files/flat_punch_2d.prm --overwrite --quiet --output-directory pressure_of_thin_layer --set "Geometry/Lower corner=0, -0.5" --set "Geometry/Upper corner=12, 0" --set "Geometry/Repetitions=24, 1"
  --set "Geometry/Initial refinements=1" --set "Refinement/Number of cycles=1" --set "Indenter/Half width=10" --set "Loading/History=1: depth 0.02" --set "Loading/Number of steps=3")
add_message_test(large_yield_strain 0 "Warning: By 'Material/Young's modulus' and 'Yield stress' a material yields at a strain of 1.9[0-9]* only, .*Are both in the same unit, such as MPa" ${_base} --validate --set "Material/Young's modulus=210")
add_message_test(locking 0 "Warning: 'Material/Poisson.s ratio' is above 0.48, and elements with 'Discretization/Volumetric treatment = standard' lock then.*Set 'Volumetric treatment = B-bar', for both" ${_base} --validate --set "Material/Poisson's ratio=0.499")
add_message_test(few_elements 0 "Warning: The contact is only [0-9]+ elements wide. with fewer than 8, force and contact area are rough. Set 'Refinement/Elements over contact radius'"
  ${_elastic_indentation} --output-directory few_elements --set "Loading/Depth=0.004" --set "Geometry/Local refinements=4")
add_message_test(few_elements_on_spots 0 "Warning: [0-9]+ % of the force is on spots of [0-9]+ that are fewer than 4 elements wide"
  ${CMAKE_SOURCE_DIR}/parameter_files/rough_surface_3d.prm --overwrite --quiet --output-directory few_elements_on_spots --set "Refinement/Number of cycles=1")
add_message_test(coarse_pixels 0 "Warning: Where the indenter touches, the elements are larger than the pixels of its height map"
  ${CMAKE_SOURCE_DIR}/parameter_files/step42/height_map.prm --overwrite --quiet --output-directory coarse_pixels --set "Refinement/Number of cycles=1" --set "Geometry/Initial refinements=4")
add_message_test(steep_indenter 0 "Warning: Step 1 leaves the theory of small strains: the slope of the indenter at the edge of the contact is 0.577 .limit: 0.25.. What follows"
  ${_elastic_indentation} --output-directory steep_indenter --set "Loading/Depth=0.06" --set "Indenter/Type=cone" --set "Indenter/Semi-apex angle=60")
add_message_test(through_body 0 "Warning: The indenter is through the body, whose height is [0-9.]+. Are the force in 'Loading' and the moduli in 'Material' in the same system of units"
  ${_elastic_indentation} --output-directory through_body --set "Loading/Control=force" --set "Loading/Force=1e7" --set "Loading/Number of steps=1")
add_message_test(deep_punch 0 "Warning: Step 2 leaves the theory of small strains: the depth over the contact radius is 0.2[0-9]* .limit: 0.2.. What follows"
  ${_elastic_indentation} --output-directory deep_punch --set "Loading/Depth=0.04" --set "Indenter/Type=circular punch" --set "Indenter/Radius=0.1")
# Surface profile, probes and evaluation
add_entry_test(profile_lines_2d "entry 'Output/Profile lines' is '0, 0. 1, 0', but in two dimensions the contact surface is a line itself" "Output/Profile lines=0, 0@ 1, 0")
set(_block Dimension=3 "Boundary conditions/Free=right, front, back")
add_entry_test(profile_line_form "entry 'Output/Profile lines' is '0, 0', but it must look like 'x, y. x, y'" ${_block} "Output/Profile lines=0, 0@ 1, 1 | 0, 0")
add_entry_test(profile_line_number "entry 'Output/Profile lines' is '0, a. 1, 1', but it must look like" ${_block} "Output/Profile lines=0, a@ 1, 1")
add_entry_test(profile_line_point "entry 'Output/Profile lines' is '1, 0. 1, 0', but both ends are the same point" ${_block} "Output/Profile lines=1, 0@ 1, 0")
add_entry_test(profile_line_outside "entry 'Output/Profile lines' is '2, 0. 3, 0', but this line does not meet any side" ${_block} "Output/Profile lines=2, 0@ 3, 0")
add_entry_test(probe_form "entry 'Output/Probe points' is '0.5, 0.5', but it must look like 'name: x, y'" "Output/Probe points=0.5, 0.5")
add_entry_test(probe_coordinates "entry 'Output/Probe points' is 'a: 0.5', but it must look like 'name: x, y'" "Output/Probe points=b: 0, 0 | a: 0.5")
add_entry_test(probe_number "entry 'Output/Probe points' is 'a: 0, inf', but it must look like" "Output/Probe points=a: 0, inf")
add_entry_test(probe_name "entry 'Output/Probe points' is 'a b: 0, 1', but it must look like .*letters, digits" "Output/Probe points=a b: 0, 1")
add_entry_test(probe_twice "entry 'Output/Probe points' is 'a: 1, 1', but there is another point, or a boundary, that is called 'a'" "Output/Probe points=a: 0, 0 | a: 1, 1")
add_entry_test(probe_as_boundary "there is another point, or a boundary, that is called 'top'" "Output/Probe points=top: 0, 0")
add_entry_test(probe_outside "entry 'Output/Probe points' is 'a: 0.6, 1.5', but that point is outside of the body. The nearest node of its mesh is .0.5, 1." "Output/Probe points=b: 0, 0 | a: 0.6, 1.5")
add_entry_test(evaluation_beta "entry 'Evaluation/Beta' is '0', but it must be greater than 0" Evaluation/Beta=0)
add_entry_test(evaluation_modulus "entry 'Evaluation/Young's modulus of the indenter' is '-1', but it must not be negative" "Evaluation/Young's modulus of the indenter=-1")
add_entry_test(evaluation_poisson "entry 'Evaluation/Poisson's ratio of the indenter' is '0.6', but it must lie between -1 and 0.5" "Evaluation/Poisson's ratio of the indenter=0.6")
add_entry_test(continuous_stiffness_of_single_step "entry 'Evaluation/Continuous stiffness' is 'true', but it is found in load histories, and there is a single load step" "Evaluation/Continuous stiffness=true" "Loading/Number of steps=1")
add_entry_test(continuous_stiffness_without_indenter "entry 'Evaluation/Continuous stiffness' is 'true', but it is that of a contact with an indenter" "Evaluation/Continuous stiffness=true" Indenter/Type=none "Boundary conditions/Contact=")
add_entry_test(evaluation_epsilon "entry 'Evaluation/Epsilon' is '1.5', but it must lie between 0.* and 1" Evaluation/Epsilon=1.5)

# In two dimensions, the two bounds of the limit load decide before anything is
# computed. Here the exact one is (2 + pi)/sqrt(3) = 2.9685.
set(_punch_force ${CMAKE_SOURCE_DIR}/parameter_files/verification/strip_punch.prm --overwrite --quiet
  --set "Geometry/Initial refinements=2" --set "Loading/Control=force" --set "Refinement/Number of cycles=1" --set "Output/Fields=never")
# (A block that is held at its sides and holds what flows bears what a large one does.)
set(_held_block --set "Geometry/Lower corner=0, -2" --set "Geometry/Upper corner=4, 0" --set "Geometry/Repetitions=4, 2" --set "Geometry/Initial refinements=1"
  --set "Boundary conditions/Fixed=bottom, right" --set "Boundary conditions/Free=")
add_message_test(unsafe_load 4 "There is no equilibrium under the force 3: the limit load of the body is between 2.8[0-9]* and 2.9[0-9]*. Prescribe a force below the first"
  ${_punch_force} ${_held_block} --output-directory unsafe_load --set "Loading/Force=3")
add_message_test(unsafe_history 4 "There is no equilibrium under the force 4: the limit load of the body is between 2.8[0-9]* and 3.0[0-9]*."
  ${_punch_force} ${_held_block} --output-directory unsafe_history --set "Loading/Force=4*t" --set "Loading/Number of steps=3")
add_message_test(validate_unsafe_load 4 "There is no equilibrium under the force 4: the limit load of the body is between 2.8[0-9]* and 3.0[0-9]*."
  ${_punch_force} ${_held_block} --validate --output-directory validate_unsafe_load --set "Loading/Force=4")
add_message_test(unsafe_rolled_metal 4 "There is no equilibrium under the force 6: the limit load of the body is between 4.6[0-9]* and 4.8[0-9]*."
  ${CMAKE_SOURCE_DIR}/parameter_files/limit_load/strip_punch_rolled.prm ${_held_block} --overwrite --quiet --output-directory unsafe_rolled_metal --set Analysis=contact
  --set "Loading/Control=force" --set "Loading/Force=6" --set "Refinement/Number of cycles=1" --set "Output/Fields=never")
add_entry_test(error_bound_back_stresses "'Analysis' is 'contact with error bound', but with 'Material/Yield criterion = Hill', the equilibrium method knows isotropic hardening only" "Material/Yield criterion=Hill" "Analysis=contact with error bound" "Material/Law=kinematic hardening" "Material/Kinematic hardening modulus=1000")
add_message_test(unsafe_circular_punch 4 "There is no equilibrium under the force 12: the limit load of the body is between 9.1[0-9]* and 9.7[0-9]*."
  ${_punch_force} ${_held_block} --output-directory unsafe_circular_punch --set "Loading/Force=12" --set "Kinematics=axisymmetric")
# The coarse mesh is another body, which may bear less.
add_message_test(safe_load_curved 0 "Warning: There is no bound of the limit load to compare the force 0.1 with. The body is curved: on a coarse mesh, it is another one. The load is applied all the same"
  ${_punch_force} --output-directory safe_load_curved --set "Geometry/Initial refinements=1" --set "Loading/Force=0.1" --set "Kinematics=axisymmetric" --set "Geometry/Type=half ball" --set "Geometry/Radius=3"
  --set "Geometry/Part=half" --set "Boundary conditions/Fixed=curved" --set "Boundary conditions/Free=" --set "Boundary conditions/Roller=left")
# The force is safe, as the second mesh tells, but the first one has no stresses that could bear it.
set(_no_bound ${CMAKE_SOURCE_DIR}/parameter_files/verification/strip_punch.prm --overwrite --quiet
  --set "Analysis=contact with error bound" --set "Geometry/Initial refinements=0" --set "Loading/Control=force"
  --set "Loading/Force=2.75" --set "Output/Fields=never")
add_message_test(no_error_bound 3 "Error: The contact problem has been solved, and the results are written, but there is no error bound on the last mesh"
  ${_no_bound} --output-directory no_error_bound --set "Refinement/Number of cycles=1")
add_message_test(no_error_bound_yet 0 "Warning: The contact problem has been solved, but there is no error bound on this mesh"
  ${_no_bound} --output-directory no_error_bound_yet --set "Refinement/Number of cycles=2")
add_message_test(error_bound_reach 3 "there is no error bound on the last mesh. No side or face of the mesh lies within the reach of the indenter as a whole"
  ${CMAKE_SOURCE_DIR}/parameter_files/error_bound/parabola.prm --quiet --overwrite --output-directory error_bound_reach
  --set "Refinement/Number of cycles=1" --set "Output/Fields=never" --set "Indenter/Reach=0.01" --set Loading/Control=depth --set Loading/Depth=0.005)
add_message_test(no_limit_load_to_compare 0 "Warning: There is no bound of the limit load to compare the force 1 with. There is no limit load: the supports enclose the body"
  ${_full_width} --output-directory no_limit_load_to_compare --set "Analysis=contact" --set "Loading/Control=force" --set "Output/Fields=never")
add_message_test(no_error_bound_tractions 2 "The tractions of .Boundary conditions/Traction. do not fit stresses of the equilibrium method on the side of the mesh from .*: there they must be polynomials of degree 1 when multiplied by r. Put jumps"
  ${CMAKE_SOURCE_DIR}/parameter_files/verification/thick_sphere_axisymmetric.prm --overwrite --quiet --output-directory no_error_bound_tractions
  --set "Analysis=contact with error bound" --set "Material/Law=linear elastic" --set "Loading/Number of steps=1" --set "Loading/Final time=1")
set(_bound_in_space ${CMAKE_SOURCE_DIR}/parameter_files/error_bound/paraboloid_3d.prm --quiet --overwrite --set "Refinement/Number of cycles=1" --set "Output/Fields=never")
add_message_test(error_bound_space_tractions 2 "A traction or displacement of 'Boundary conditions' is not linear on the faces of the mesh, near the point .*. In space, the equilibrium method is for such"
  ${_bound_in_space} --validate --set "Boundary conditions/Free=back" --set "Boundary conditions/Traction=right: y*z@ 0@ 0")
add_message_test(error_bound_space_displacement 2 "A traction or displacement of 'Boundary conditions' is not linear on the faces of the mesh, near the point .*. In space, the equilibrium method is for such"
  ${_bound_in_space} --validate --set "Boundary conditions/Fixed=" --set "Boundary conditions/Prescribed displacement=bottom: 0@ 0@ 0.01*x*y")
add_message_test(error_bound_space_reach 3 "there is no error bound on the last mesh. The indenter reaches a small part of a face of the mesh only, where the gap cannot be bounded"
  ${_bound_in_space} --output-directory error_bound_space_reach --set "Indenter/Reach=0.005")
# A load that the equilibrium method does not know is for the load steps.
add_message_test(safe_load_by_position 0 "Warning: There is no bound of the limit load to compare the largest load of tractions and body forces with. The body force .'Body force'. depends on the position. The equilibrium method is for constant ones. .* The load is applied all the same"
  ${_files}/pulled_too_far.prm --quiet --overwrite --output-directory safe_load_by_position --set "Body force=0@ -0.01*(1 + 0.01*x)" --set "Boundary conditions/Traction=right: 0.1*t@ 0")
# With tractions, be they zero, the program comes to the limit itself. Steps that are
# taken back and cut come closer: under a circular punch, the exact one is 10.3.
set(_circular_punch ${_punch_force} --set "Kinematics=axisymmetric" --set "Boundary conditions/Free=" --set "Boundary conditions/Traction=right: 0@ 0")
add_message_test(beyond_limit_load 4 "No equilibrium has been found for the force 30 .t = 1.: it seems to be beyond the limit load of the body, whose material stops hardening. The largest force reached is 0"
  ${_circular_punch} --output-directory beyond_limit_load --set "Loading/Force=30")
add_message_test(close_to_limit_load 4 "Error: No equilibrium .* The largest force reached is 10.*, at the depth 0.0"
  ${_circular_punch} --output-directory close_to_limit_load --set "Loading/Force=20"
  --set "Loading/Number of steps=4" --set "Loading/Maximum number of cuts=3")
add_message_test(tractions_beyond_limit 4 "Error: No equilibrium has been found under the tractions and body forces at t = 0.57[0-9]*: they seem to be beyond the limit load of the body, whose material stops hardening. The last equilibrium is that at t = 0.57[0-9]*. Prescribe smaller ones"
  ${_files}/pulled_too_far.prm --quiet --overwrite --output-directory tractions_beyond_limit --set Dimension=3
  --set "Boundary conditions/Roller=left, bottom, front, back" --set "Boundary conditions/Traction=right: 2*t@ 0@ 0")
add_message_test(unsafe_tractions 4 "Error: There is no equilibrium under the largest load of tractions and body forces: the limit load of the body is between 0.57735[0-9]* and 0.57735[0-9]* times that. Prescribe smaller loads"
  ${_files}/pulled_too_far.prm --quiet --overwrite --output-directory unsafe_tractions)
# Quadratic elements lock a little: they would bear more than the limit, 0.909 times the pressure, with displacements far
# beyond the size of the body; with B-bar, Newton's method follows the body until its system is singular.
set(_sphere_beyond_limit ${CMAKE_SOURCE_DIR}/parameter_files/verification/thick_sphere_axisymmetric.prm --quiet --overwrite
  --set "Boundary conditions/Traction=inner: 366*t*x/sqrt(x^2+y^2)@ 366*t*y/sqrt(x^2+y^2)" --set "Loading/Final time=1" --set "Loading/Number of steps=5"
  --set "Loading/Maximum number of cuts=2" --set "Geometry/Initial refinements=0" --set "Linear solver/Type=direct" --set "Output/Fields=never")
foreach(_treatment standard B-bar)
  add_message_test(sphere_beyond_limit_${_treatment} 4 "Error: No equilibrium has been found under the tractions and body forces at t = 0.9[0-9]*: they seem to be beyond the limit load of the body, whose material stops hardening. The last equilibrium is that at t = 0.[89][0-9]*. Prescribe"
    ${_sphere_beyond_limit} --output-directory sphere_beyond_limit_${_treatment} --set "Discretization/Volumetric treatment=${_treatment}")
endforeach()
# The exact limit of the punch is 10.3: what the first mesh bears, the next one does not.
add_message_test(adapted_mesh_too_soft 0 "Warning: No equilibrium has been found on the adapted mesh under the load of step 5. the next step begins with the interpolated state"
  ${_circular_punch} --output-directory adapted_mesh_too_soft --set "Loading/History=1: force 10.5 | 2: force 0"
  --set "Loading/Number of steps=10" --set "Loading/Maximum number of cuts=2"
  --set "Refinement/Steps between adaptations=5" --set "Refinement/Refinement fraction=0.1")
# A punch that is narrower than an element comes between two nodes.
foreach(_load "force 836.8" "force 0" "depth 0.01")
  string(MAKE_C_IDENTIFIER ${_load} _name)
  add_message_test(nothing_below_${_name} 3 "Error: Load step 2 from t = 1 .depth 0.0079[0-9]*. fails even if it ends at t = 2, .*The indenter has left the contact boundary: there is nothing below it"
    ${CMAKE_SOURCE_DIR}/parameter_files/friction/mindlin_cylinder.prm --quiet --overwrite --output-directory nothing_below_${_name} --set "Geometry/Local refinements=0"
    --set "Refinement/Elements over contact radius=0" --set "Indenter/Type=strip punch" --set "Indenter/Half width=0.1"
    --set "Loading/History=1: force 836.8 | 2: ${_load}" --set "Loading/Path=1: 0 | 2: 1" --set "Loading/Number of steps=2"
    --set "Loading/Maximum number of cuts=0" --set "Output/Fields=never")
endforeach()
add_message_test(sinks_without_end 3 "The indenter sinks without end: its depth exceeds the size of the body by far"
  ${_base} --output-directory sinks_without_end --overwrite --quiet --set "Loading/Control=force" --set "Loading/Force=1e12")

# Initial stress
add_entry_test(initial_stress_across_section "entry 'Initial stress/Stress xz' is '1', but a body in two dimensions bears no shear across its section" "Initial stress/Stress xz=1")
add_entry_test(initial_stress_across_sheet "entry 'Initial stress/Stress zz' is '1', but a sheet bears no stress across" "Initial stress/Stress zz=1" "Kinematics=plane stress")
add_entry_test(initial_stress_of_time "entry 'Initial stress/Stress xx' is 't', but this is not an expression in x,y" "Initial stress/Stress xx=t")
add_entry_test(initial_stress_infinite "entry 'Initial stress/Stress xx' is '1/.x-x.', but at .* its value is" "Initial stress/Stress xx=1/(x-x)")
add_entry_test(initial_stress_yields "The 'Initial stress' is beyond the yield stress: at .* the equivalent stress is 1000000000, and 'Material/Yield stress' is" "Initial stress/Stress xx=1e9")
add_message_test(initial_stress_completed_yields 2 "The 'Initial stress', completed by what supports and loads at t = 0 ask for, is beyond the yield stress: at .* the equivalent stress is 405" ${CMAKE_SOURCE_DIR}/parameter_files/material/uniaxial_isotropic.prm --validate --set "Boundary conditions/Prescribed displacement=" --set "Boundary conditions/Traction=top: 0@ 0@ 405" --set "Initial stress/Stress zz=395")
add_entry_test(initial_stress_unbalanced "The 'Initial stress' is not in equilibrium with supports and loads: at t = 0, .* % of it" "Initial stress/Stress yy=1")
add_entry_test(initial_stress_limit_load "'Analysis = limit load' finds what does not depend on an initial stress" "Analysis=limit load" "Material/Law=perfectly plastic" "Initial stress/Stress xx=1")
add_entry_test(initial_stress_error_bound "The 'Initial stress' is not linear on the cells of the mesh" "Analysis=contact with error bound" "Initial stress/Stress xx=x^2")

# What --validate looks at beyond the entries, in the order of the constructor
# of ElastoPlasticContact and of validate(): mesh, supports and contact have
# their lines above.
set(_sheet ${CMAKE_SOURCE_DIR}/parameter_files/material/plane_stress_tension.prm --validate)
set(_following ${CMAKE_SOURCE_DIR}/parameter_files/indentation/sphere_axisymmetric.prm --set "Geometry/Initial refinements=3" --set "Loading/History=1: depth 0.01"
  --set "Loading/Number of steps=6" --set "Refinement/Elements over contact radius=8" --set "Refinement/Maximum number of unknowns=900" --set Output/Fields=never)
add_entry_test(field_time_beyond "entry 'Output/Field times' is '0.5, 2', but there are no fields at 2: .*end at t = 1" "Output/Fields=at times" "Output/Field times=0.5, 2")
add_entry_test(field_time_zero "entry 'Output/Field times' is '0', but there are no fields at 0: the load steps begin at t = 0" "Output/Fields=at times" "Output/Field times=0")
add_entry_test(body_force_later "entry 'Body force' is 'sqrt.0.6-t.', but at .* and t = 0.75 its value is not a number" "Body force=0@ sqrt(0.6-t)" "Loading/Number of steps=4")
add_message_test(traction_later 2 "entry 'Boundary conditions/Traction' is 'sqrt.1-t.', but at .* and t = 1.05 its value is not a number" ${_sheet} --set "Boundary conditions/Free=" --set "Boundary conditions/Traction=right: sqrt(1-t)@ 0")
add_message_test(no_load 2 "Error: .*Nothing loads the body: at the ends of all load steps, .* are zero" ${_sheet} --set "Boundary conditions/Prescribed displacement=top: free@ 0*t")
add_message_test(initial_stress_zero 2 "Nothing loads the body: .* body forces and the initial stress are zero" ${_sheet} --set "Boundary conditions/Prescribed displacement=top: free@ 0*t" --set "Initial stress/Stress xx=0*x")
add_entry_test(history_without_indenter "'Loading/History' is '1: depth 0.1', but there is no indenter" Indenter/Type=none "Boundary conditions/Contact=" "Boundary conditions/Free=top, right" "Loading/History=1: depth 0.1")
add_entry_test(no_force "Nothing loads the body" Loading/Control=force Loading/Force=0)
add_message_test(mesh_will_stop 0 "Warning: The mesh is expected to stop following the contact at some step: it would have about [0-9]+ unknowns in the end" ${_following} --validate)
add_message_test(little_memory 0 "Warning: The run is expected to need about [0-9]+ MB of memory, and there are [0-9]+ MB here" ${CMAKE_SOURCE_DIR}/parameter_files/sphere_3d.prm --validate
  --set Refinement/Strategy=global --set "Refinement/Number of cycles=9" --set "Refinement/Maximum number of unknowns=2000000000"
  --set "Discretization/Volumetric treatment=B-bar" --set "Material/Poisson's ratio=0.4999")

# Entries that are set in vain, and stresses in two units: warnings of --validate
set(_in_vain "Warning: Entries that are set and have no effect: ")
add_message_test(no_effect_beside_history 0 "${_in_vain}'Loading/Depth' .'Loading/History' takes its place.. Leave them out" ${_base} --validate --set "Loading/History=1: depth 0.001")
add_message_test(no_effect_of_type 0 "${_in_vain}'Indenter/Radius' .it is for 'Indenter/Type = sphere, paraboloid, cylinder, circular punch or spheroconical tip', which is 'cone'" ${_base} --validate --set Indenter/Type=cone --set Indenter/Radius=3)
add_message_test(no_effect_of_force 0 "${_in_vain}'Loading/Force' .it is for 'Loading/Control = force', which is 'depth'" ${_base} --validate --set Loading/Force=3)
add_message_test(no_effect_in_limit_load 0 "${_in_vain}.*'Loading/Number of steps' .'Analysis' is 'limit load'" ${_limit_load}/strip_punch.prm --validate --set "Loading/Number of steps=3")
add_message_test(stress_in_gpa 0 "Warning: 'Material/Young's modulus' of material 0 is more than 1e5 times its 'Yield stress', as no solid's is. Are all stresses in the same unit, such as MPa" ${_base} --validate --set "Material/Yield stress=0.4")
add_message_test(hardening_beyond_modulus 0 "Warning: 'Material/Isotropic hardening modulus' of material 0 is larger than its 'Young's modulus'. Are all stresses in the same unit" ${_base} --validate --set "Material/Young's modulus=1000")

# A warning, and the program goes on.
add_message_test(mesh_stops 0 "Warning: From step [0-9]+ on, the mesh does not follow the contact: the next one would have more unknowns than 'Refinement/Maximum number of unknowns' allows"
  ${_following} --quiet --overwrite --output-directory mesh_stops)
add_message_test(step_is_cut 3 "Warning: The step from t = 0 has not converged. trying half of it"
  ${_base} --output-directory step_is_cut --overwrite --quiet --set "Loading/Number of steps=2" --set "Loading/Maximum number of cuts=1"
  --set "Nonlinear solver/Maximum number of iterations=1" --set Loading/Depth=0.1)
add_message_test(multigrid_fails 0 "Warning: Conjugate gradients with geometric multigrid do not converge here: a factorisation takes over on this mesh"
  ${CMAKE_SOURCE_DIR}/parameter_files/verification/strip_punch.prm --output-directory multigrid_fails --overwrite --quiet
  --set "Geometry/Initial refinements=2" --set "Refinement/Number of cycles=1" --set "Linear solver/Type=multigrid" --set "Linear solver/Maximum number of iterations=10")

# A body of a nanometre in metres: numbers of the levels are beyond single precision.
add_message_test(multigrid_of_tiny_cells 0 "Warning: Conjugate gradients with geometric multigrid do not converge here: a factorisation takes over on this mesh"
  ${CMAKE_SOURCE_DIR}/parameter_files/indentation/sphere_axisymmetric.prm --output-directory multigrid_of_tiny_cells --overwrite --quiet --set "Output/Fields=never"
  --set "Geometry/Lower corner=0, -1e-9" --set "Geometry/Upper corner=1e-9, 0" --set "Geometry/Local refinements=0" --set "Refinement/Elements over contact radius=0"
  --set "Linear solver/Type=multigrid" --set "Indenter/Radius=1e-9" --set "Loading/History=1: depth 2e-11" --set "Loading/Number of steps=1"
  --set "Material/Young's modulus=2e11" --set "Material/Yield stress=4e8")

# Little memory is played by a limit on addresses, in KB: enough for the rest.
add_test(NAME messages/no_memory_for_factors
  COMMAND ${CMAKE_COMMAND} -DSTATUS=5 "-DMESSAGE=MUMPS cannot factorise the system..*INFOG.1. = -[0-9]+ .*not enough memory"
    -P ${CMAKE_CURRENT_SOURCE_DIR}/expect_message.cmake --
    sh -c "ulimit -v 1200000 && exec \"$@\"" sh
    $<TARGET_FILE:elasto_plastic_contact> ${CMAKE_SOURCE_DIR}/parameter_files/flat_punch_2d.prm --output-directory no_memory_for_factors --overwrite
    --quiet --set "Geometry/Initial refinements=4" --set "Refinement/Number of cycles=1"
  WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR})
set_tests_properties(messages/no_memory_for_factors PROPERTIES LABELS messages TIMEOUT 60)

# Output
add_entry_test(no_field_times "'Output/Field times' is '', but with 'Output/Fields = at times' it must name at least one time" "Output/Fields=at times")
add_message_test(negative_minutes 2 "'Output/Minutes between checkpoints' is '-1', but it must be: number >= 0" ${_base} --set "Output/Minutes between checkpoints=-1")
add_message_test(results_exist 2 "results' holds results already \\(history.csv\\).*--overwrite" ${_base} --output-directory ${_files}/results)
add_message_test(results_interrupted 2 "interrupted' holds results already.*--overwrite to replace them, or --resume to go on from their checkpoint" ${_base} --output-directory ${_files}/interrupted)
# (found also by --validate)
foreach(_option --validate --quiet)
  add_message_test(output_is_file${_option} 5 "base.prm' stands in the way of the results: the program has not written it" ${_base} ${_option} --output-directory ${_base})
  add_message_test(output_below_file${_option} 5 "base.prm' stands in the way of the results: the program has not written it" ${_base} ${_option} --output-directory ${_base}/results)
  add_message_test(lock_is_folder${_option} 5 "lock_is_folder/.lock' stands in the way of the results: the program has not written it" ${_base} ${_option} --output-directory ${_files}/lock_is_folder)
endforeach()

# Processes that have been told different things, and one on a machine without the
# files: a folder in the place of the machine.
file(MAKE_DIRECTORY ${_here}/with_files ${_here}/without_files)
file(COPY ${_files}/square.msh DESTINATION ${_here}/with_files)
file(WRITE ${_here}/with_files/case.prm "include ${_base}\nsubsection Geometry\n set Type = file\n set File = square.msh\nend\nsubsection Boundary conditions\n set Roller =\n set Free = 0\nend\n"
  "subsection Output\n set Fields = at times\n set Field times = 2\nend\n")
# (By a shell, since mpirun of Open MPI 5.0.7 crashes if it is to start two programs.)
function(add_two_processes_test _name _status _message _first _second)
  add_test(NAME messages/${_name}
    COMMAND ${CMAKE_COMMAND} -DSTATUS=${_status} "-DMESSAGE=${_message}"
      -P ${CMAKE_CURRENT_SOURCE_DIR}/expect_message.cmake --
      ${DEAL_II_MPIEXEC} ${DEAL_II_MPIEXEC_NUMPROC_FLAG} 2
      sh -c "[ \${OMPI_COMM_WORLD_RANK:-\$PMI_RANK} -eq 0 ] && ${_first} --validate || ${_second} --validate"
    WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR})
  set_tests_properties(messages/${_name} PROPERTIES LABELS messages TIMEOUT 60 PROCESSORS 2)
endfunction()
set(_run "exec '$<TARGET_FILE:elasto_plastic_contact>'")
add_two_processes_test(different_arguments 2 "Error: Wrong usage: all processes of a run must have the same arguments, but the first has '[^ ]*base.prm --validate' and another 'missing.prm --validate'"
  "${_run} '${_base}'" "${_run} missing.prm")
add_two_processes_test(files_of_one_machine 2 "Error: case.prm: The entry 'Output/Field times' is '2', but there are no fields at 2"
  "cd '${_here}/with_files' && ${_run} case.prm" "cd '${_here}/without_files' && ${_run} case.prm")

# Another run in the folder
add_test(NAME messages/output_in_use
  COMMAND ${CMAKE_COMMAND} -DSTATUS=5 "-DMESSAGE=^Error: The output directory 'output_in_use' is in use by another run of the program"
    -P ${CMAKE_CURRENT_SOURCE_DIR}/expect_message.cmake --
    $<TARGET_FILE:Python3::Interpreter> ${CMAKE_CURRENT_SOURCE_DIR}/with_lock.py output_in_use/.lock
    $<TARGET_FILE:elasto_plastic_contact> ${_base} --output-directory output_in_use --overwrite
  WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR})
set_tests_properties(messages/output_in_use PROPERTIES LABELS messages TIMEOUT 60)

# A full disk is played by a limit on the size of files, in units of 512 bytes;
# scripts/command.py full_disk_test fills a real one.
# Open MPI needs larger ones, unless it is told that the process is alone.
function(add_disk_full_test _name _limit _file)
  add_test(NAME messages/${_name}
    COMMAND ${CMAKE_COMMAND} -DSTATUS=5 "-DMESSAGE=${_file}' could not be written completely"
      -P ${CMAKE_CURRENT_SOURCE_DIR}/expect_message.cmake --
      sh -c "trap '' XFSZ && ulimit -f ${_limit} && exec \"$@\"" sh
      env OMPI_MCA_ess_singleton_isolated=1 OMPI_MCA_btl=self PMIX_MCA_gds=hash
      $<TARGET_FILE:elasto_plastic_contact> ${_base} --output-directory ${_name} --overwrite
      ${ARGN}
    WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR})
  set_tests_properties(messages/${_name} PROPERTIES LABELS messages TIMEOUT 60)
endfunction()

add_disk_full_test(disk_full_at_start 8 parameters.prm)
# (The limits of the other two are above the size of parameters.prm, which is about 33 KB.)
add_disk_full_test(disk_full_at_fields 128 solution-.*.vtu --set "Geometry/Initial refinements=6")
add_disk_full_test(disk_full_at_checkpoint 128 checkpoint.new/.*-0000 --set "Output/Fields=never" --set "Geometry/Initial refinements=6" --set "Loading/Number of steps=3")
