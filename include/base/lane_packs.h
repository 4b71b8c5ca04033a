// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef base_lane_packs_h
#define base_lane_packs_h

#include <array>
#include <cstring>
#include <utility>

#include "base/simd.h"

namespace ElastoPlastic
{
  /// Takes dim numbers that follow each other in memory, at a different place
  /// for each lane of a batch, to dim batches, and adds such batches to them:
  /// with the processor's shuffles of whole registers in place of moves number
  /// by number. @p Number is a Simd.
  ///
  /// Numbers are read in packs of pack_size: in three dimensions, read() also
  /// reads the number that follows the three, which must exist. add() touches
  /// the three only.
  template <int dim, typename Number>
  class LanePacks
  {
  public:
    using value_type = typename Number::value_type;
    using Batches    = std::array<Number, dim>;

    static constexpr int pack_size = (dim == 3 ? 4 : 2);

    /// Lane l has the numbers that begin at vector[places[l]].
    ELASTO_PLASTIC_ALWAYS_INLINE static inline void
    read(Batches                  &batches,
         const value_type *const   vector,
         const unsigned int *const places)
    {
      if constexpr (fills_registers)
        {
          std::array<Register, pack_size> registers;
          for (int k = 0; k < pack_size; ++k)
            registers[k] = read_packs<n_packs>(vector, places + k * n_packs);
          set_batches(batches,
                      registers,
                      std::make_integer_sequence<int, dim>());
        }
      else
        for (int lane = 0; lane < n_lanes; ++lane)
          for (int c = 0; c < dim; ++c)
            batches[c][lane] = vector[places[lane] + c];
    }

    /// One lane after the other: their places may be the same.
    ELASTO_PLASTIC_ALWAYS_INLINE static inline void
    add(value_type *const         vector,
        const Batches            &batches,
        const unsigned int *const places)
    {
      if constexpr (fills_registers)
        add_registers(vector,
                      batches,
                      places,
                      std::make_integer_sequence<int, pack_size>());
      else
        for (int lane = 0; lane < n_lanes; ++lane)
          for (int c = 0; c < dim; ++c)
            vector[places[lane] + c] += batches[c][lane];
    }

  private:
    static constexpr int n_lanes = Number::size();
    /// In a register.
    static constexpr int  n_packs         = n_lanes / pack_size;
    static constexpr bool fills_registers = n_packs > 0;

    template <int n>
    struct VectorOf
    {
      using type [[gnu::vector_size(n * sizeof(value_type))]] = value_type;
    };
    template <int n>
    using Vector   = typename VectorOf<n>::type;
    using Register = Vector<n_lanes>;
    using Pair     = Vector<2>;

    template <int... entries>
    using Entries = std::integer_sequence<int, entries...>;

    static constexpr std::make_integer_sequence<int, n_lanes> all_entries{};

    /// A vector with @p n packs.
    template <int n>
    ELASTO_PLASTIC_ALWAYS_INLINE static inline Vector<n * pack_size>
    read_packs(const value_type *const vector, const unsigned int *const places)
    {
      if constexpr (n == 1)
        {
          Vector<pack_size> pack;
          std::memcpy(&pack, vector + *places, sizeof(pack));
          return pack;
        }
      else
        return join(read_packs<n / 2>(vector, places),
                    read_packs<n / 2>(vector, places + n / 2),
                    std::make_integer_sequence<int, n * pack_size>());
    }

    template <typename Half, int... i>
    ELASTO_PLASTIC_ALWAYS_INLINE static inline auto
    join(const Half &a, const Half &b, Entries<i...>)
    {
      return __builtin_shufflevector(a, b, i...);
    }

    template <int... components>
    ELASTO_PLASTIC_ALWAYS_INLINE static inline void
    set_batches(Batches                               &batches,
                const std::array<Register, pack_size> &registers,
                Entries<components...>)
    {
      (set_batch<components>(batches, registers), ...);
    }

    template <int component>
    ELASTO_PLASTIC_ALWAYS_INLINE static inline void
    set_batch(Batches                               &batches,
              const std::array<Register, pack_size> &registers)
    {
      Register result =
        collect<component>(registers[0], registers[1], all_entries);
      if constexpr (pack_size == 4)
        result = join_first_halves(result,
                                   collect<component>(registers[2],
                                                      registers[3],
                                                      all_entries),
                                   all_entries);
      std::memcpy(&batches[component], &result, sizeof(result));
    }

    /// First the entries @p component of all packs of @p a, then those of
    /// @p b; what follows does not matter.
    template <int component, int... i>
    ELASTO_PLASTIC_ALWAYS_INLINE static inline Register
    collect(const Register &a, const Register &b, Entries<i...>)
    {
      return __builtin_shufflevector(
        a,
        b,
        (i < 2 * n_packs ?
           (i / n_packs) * n_lanes + pack_size * (i % n_packs) + component :
           -1)...);
    }

    template <int... i>
    ELASTO_PLASTIC_ALWAYS_INLINE static inline Register
    join_first_halves(const Register &a, const Register &b, Entries<i...>)
    {
      return __builtin_shufflevector(a,
                                     b,
                                     (i + (2 * i / n_lanes) * n_lanes / 2)...);
    }

    template <int... registers>
    ELASTO_PLASTIC_ALWAYS_INLINE static inline void
    add_registers(value_type *const         vector,
                  const Batches            &batches,
                  const unsigned int *const places,
                  Entries<registers...>)
    {
      std::array<Register, dim> components;
      std::memcpy(components.data(), batches.data(), sizeof(components));
      (add_packs(vector,
                 packs<registers>(components),
                 places + registers * n_packs,
                 std::make_integer_sequence<int, n_packs>()),
       ...);
    }

    /// The packs of lanes from k n_packs on.
    template <int k>
    ELASTO_PLASTIC_ALWAYS_INLINE static inline Register
    packs(const std::array<Register, dim> &components)
    {
      if constexpr (pack_size == 2)
        return interleave<k>(components[0], components[1], all_entries);
      else
        return interleave_pairs<k % 2>(
          interleave<k / 2>(components[0], components[1], all_entries),
          interleave<k / 2>(components[2], components[2], all_entries),
          all_entries);
    }

    /// a_0, b_0, a_1, b_1, ... of the first (0) or second (1) halves.
    template <int half, int... i>
    ELASTO_PLASTIC_ALWAYS_INLINE static inline Register
    interleave(const Register &a, const Register &b, Entries<i...>)
    {
      return __builtin_shufflevector(
        a, b, (half * n_lanes / 2 + i / 2 + (i % 2) * n_lanes)...);
    }

    template <int half, int... i>
    ELASTO_PLASTIC_ALWAYS_INLINE static inline Register
    interleave_pairs(const Register &a, const Register &b, Entries<i...>)
    {
      return __builtin_shufflevector(a,
                                     b,
                                     (half * n_lanes / 2 + 2 * (i / 4) + i % 2 +
                                      ((i / 2) % 2) * n_lanes)...);
    }

    template <int... lanes>
    ELASTO_PLASTIC_ALWAYS_INLINE static inline void
    add_packs(value_type *const         vector,
              const Register           &packs,
              const unsigned int *const places,
              Entries<lanes...>)
    {
      (add_pack<lanes>(vector + places[lanes], packs), ...);
    }

    template <int lane>
    ELASTO_PLASTIC_ALWAYS_INLINE static inline void
    add_pack(value_type *const place, const Register &packs)
    {
      constexpr int first = lane * pack_size;
      Pair          pair;
      std::memcpy(&pair, place, sizeof(pair));
      pair += __builtin_shufflevector(packs, packs, first, first + 1);
      std::memcpy(place, &pair, sizeof(pair));
      if constexpr (dim == 3)
        place[2] += packs[first + 2];
    }
  };
} // namespace ElastoPlastic

#endif
