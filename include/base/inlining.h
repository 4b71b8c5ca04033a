// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef base_inlining_h
#define base_inlining_h

#include <deal.II/base/config.h>

/// For the small functions of points and cells, which the compiler must inline
/// wherever it optimises. A Debug build does not optimise: there, it would only
/// make large functions, which take three times as long to compile.
#ifdef DEBUG
#  define ELASTO_PLASTIC_ALWAYS_INLINE
#else
#  define ELASTO_PLASTIC_ALWAYS_INLINE DEAL_II_ALWAYS_INLINE
#endif

#endif
