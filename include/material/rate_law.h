// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef material_rate_law_h
#define material_rate_law_h

namespace ElastoPlastic
{
  /// The values of the entry "Rate law".
  enum class RateLawType
  {
    none,
    perzyna,
    norton,
    cowper_symonds,
    duvaut_lions
  };



  /// How the flow of a material depends on the rate r of its equivalent plastic
  /// strain (doc/theory, "Rate dependence"). The first three make the flow
  /// stress of the yield stress sigma_Y and the overstress ratio y = (r /
  /// r_0)^(1/n):
  ///
  ///  - sigma_Y + D y @cite perzyna_1966,
  ///  - min(D y, sigma_Y), power law creep @cite norton_1929 below the yield
  ///    stress,
  ///  - sigma_Y (1 + y) @cite cowper_symonds_1957.
  ///
  /// The last @cite duvaut_lions_1972 lets stress and hardening approach, with
  /// a relaxation time, what they would be without it.
  struct RateLaw
  {
    RateLawType type = RateLawType::none;
    /// n >= 1
    double exponent = 1;
    /// r_0, unit: 1 / time
    double reference_rate = 1;
    /// D, unit: stress
    double stress = 1;
    /// unit: time
    double relaxation_time = 1;

    /// A flow stress and its derivatives.
    struct Value
    {
      double stress, by_yield_stress, by_ratio;
    };

    /// Whether there is an overstress ratio.
    bool
    has_ratio() const
    {
      return type != RateLawType::none && type != RateLawType::duvaut_lions;
    }

    /// With these @p yield_stress and @p ratio. (Of a material without a ratio,
    /// it is the yield stress.)
    Value
    flow_stress(const double yield_stress, const double ratio) const
    {
      switch (type)
        {
          case RateLawType::perzyna:
            return {yield_stress + stress * ratio, 1., stress};
          case RateLawType::norton:
            if (stress * ratio < yield_stress)
              return {stress * ratio, 0., stress};
            break;
          case RateLawType::cowper_symonds:
            return {yield_stress * (1. + ratio), 1. + ratio, yield_stress};
          default:
            break;
        }
      return {yield_stress, 1., 0.};
    }

    /// The part of the way to the state without rate dependence that is covered
    /// in a step of this @p duration, by the implicit Euler method.
    double
    relaxation(const double duration) const
    {
      return type == RateLawType::duvaut_lions ?
               duration / (relaxation_time + duration) :
               1.;
    }
  };
} // namespace ElastoPlastic

#endif
