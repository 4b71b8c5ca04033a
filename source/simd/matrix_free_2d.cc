// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "instantiate_matrix_free.h"

INSTANTIATE_MATRIX_FREE(2, float)
INSTANTIATE_MATRIX_FREE(2, double)
INSTANTIATE_MAPPING_EVALUATION(2)
