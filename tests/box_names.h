// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tests_box_names_h
#define tests_box_names_h

#include "mesh/boundary_names.h"

/// Of the sides of a box in space whose boundaries deal.II has numbered.
const ElastoPlastic::BoundaryNames names_of_box = {{"left", 0},
                                                   {"right", 1},
                                                   {"front", 2},
                                                   {"back", 3},
                                                   {"bottom", 4},
                                                   {"top", 5}};

#endif
