// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <new>
#include <utility>

#include "bounds/conic/side_by_side.h"
#include "bounds/conic/sparse_cholesky.h"

namespace ElastoPlastic
{
  namespace
  {
    using Lists   = std::vector<std::vector<unsigned int>>;
    using Indices = std::vector<SuiteSparse_long>;



    /// Unknowns that belong to the same of the @p coupled lists have entries in
    /// the same columns, and are a group: the number of that of each unknown,
    /// not all of which exist.
    std::vector<unsigned int>
    numbers_of_groups(const unsigned int n, const Lists &coupled)
    {
      std::vector<unsigned int> numbers(n, 0);
      unsigned int              n_groups = 1;
      for (const std::vector<unsigned int> &list : coupled)
        {
          // Which group becomes which, as far as it is in this list.
          std::vector<std::pair<unsigned int, unsigned int>> parts;
          for (const unsigned int i : list)
            {
              auto part =
                std::find_if(parts.begin(), parts.end(), [&](const auto &p) {
                  return p.first == numbers[i];
                });
              if (part == parts.end())
                part = parts.insert(part, {numbers[i], n_groups++});
              numbers[i] = part->second;
            }
        }
      return numbers;
    }



    /// The unknowns of each group.
    Lists
    find_groups(const unsigned int n, const Lists &coupled)
    {
      const auto numbers = numbers_of_groups(n, coupled);
      Lists      groups;
      for (unsigned int i = 0; i < n; ++i)
        {
          if (numbers[i] >= groups.size())
            groups.resize(numbers[i] + 1);
          groups[numbers[i]].push_back(i);
        }
      groups.erase(std::remove_if(groups.begin(),
                                  groups.end(),
                                  [](const auto &group) {
                                    return group.empty();
                                  }),
                   groups.end());
      return groups;
    }



    /// Which groups are coupled with each, itself included.
    Lists
    find_neighbors(const unsigned int n,
                   const Lists       &groups,
                   const Lists       &coupled)
    {
      std::vector<unsigned int> first(n, n); // of a group: its number
      for (unsigned int g = 0; g < groups.size(); ++g)
        first[groups[g].front()] = g;
      Lists neighbors(groups.size());
      for (unsigned int g = 0; g < groups.size(); ++g)
        neighbors[g].push_back(g);
      for (const std::vector<unsigned int> &list : coupled)
        {
          std::vector<unsigned int> of_list;
          for (const unsigned int i : list)
            if (first[i] < n)
              of_list.push_back(first[i]);
          for (const unsigned int g : of_list)
            neighbors[g].insert(neighbors[g].end(),
                                of_list.begin(),
                                of_list.end());
        }
      for (std::vector<unsigned int> &list : neighbors)
        {
          std::sort(list.begin(), list.end());
          list.erase(std::unique(list.begin(), list.end()), list.end());
        }
      return neighbors;
    }



    /// A pattern of columns, the upper half of which CHOLMOD reads.
    struct Pattern
    {
      Indices begins = {0};
      Indices rows;

      void
      end_column()
      {
        begins.push_back(rows.size());
      }

      cholmod_sparse
      view()
      {
        cholmod_sparse matrix = {};
        matrix.nrow = matrix.ncol = begins.size() - 1;
        matrix.nzmax              = rows.size();
        matrix.p                  = begins.data();
        matrix.i                  = rows.data();
        matrix.stype              = 1;
        matrix.itype              = CHOLMOD_LONG;
        matrix.xtype              = CHOLMOD_PATTERN;
        matrix.dtype              = CHOLMOD_DOUBLE;
        matrix.packed             = 1;
        return matrix;
      }
    };



    Pattern
    pattern_of_groups(const Lists &neighbors)
    {
      Pattern pattern;
      for (const std::vector<unsigned int> &list : neighbors)
        {
          pattern.rows.insert(pattern.rows.end(), list.begin(), list.end());
          pattern.end_column();
        }
      return pattern;
    }



    Pattern
    pattern_of_unknowns(const unsigned int n,
                        const Lists       &groups,
                        const Lists       &neighbors)
    {
      std::vector<unsigned int> numbers(n);
      for (unsigned int g = 0; g < groups.size(); ++g)
        for (const unsigned int i : groups[g])
          numbers[i] = g;
      Pattern pattern;
      for (unsigned int i = 0; i < n; ++i)
        {
          for (const unsigned int g : neighbors[numbers[i]])
            for (const unsigned int j : groups[g])
              if (j <= i)
                pattern.rows.push_back(j);
          pattern.end_column();
        }
      return pattern;
    }
  } // namespace



  SparseCholesky::Common::Common()
  {
    cholmod_l_start(this);
    print = 0; // Errors are reported by return values.
  }



  // METIS' own ordering would catch SIGTERM, CHOLMOD's nested dissection does
  // not.
  std::vector<SuiteSparse_long>
  SparseCholesky::find_order(cholmod_sparse pattern)
  {
    common.nmethods           = 2;
    common.method[0].ordering = CHOLMOD_AMD;
    common.method[1].ordering = CHOLMOD_NESDIS;
    common.supernodal         = CHOLMOD_SIMPLICIAL;
    factor.reset(cholmod_l_analyze(&pattern, &common));
    if (!factor)
      throw std::bad_alloc();
    const auto *const order =
      static_cast<const SuiteSparse_long *>(factor->Perm);
    return {order, order + factor->n};
  }



  // Unknowns of a group are eliminated one after the other: so the graph of
  // groups is all that has to be ordered.
  SparseCholesky::SparseCholesky(const unsigned int n, const Lists &coupled)
    : factor(nullptr, FactorDeleter{&common})
  {
    const Lists groups    = find_groups(n, coupled);
    const Lists neighbors = find_neighbors(n, groups, coupled);
    Pattern     of_groups = pattern_of_groups(neighbors),
            pattern       = pattern_of_unknowns(n, groups, neighbors);
    Indices order;
    order.reserve(n + 1); // CHOLMOD takes no null pointer
    for (const auto g : find_order(of_groups.view()))
      order.insert(order.end(), groups[g].begin(), groups[g].end());

    common.nmethods           = 1;
    common.method[0].ordering = CHOLMOD_GIVEN;
    common.supernodal         = CHOLMOD_SUPERNODAL;
    cholmod_sparse matrix     = pattern.view();
    factor.reset(
      cholmod_l_analyze_p(&matrix, order.data(), nullptr, 0, &common));
    if (!factor)
      throw std::bad_alloc();
    fronts                 = std::make_unique<MultifrontalFactor>(*factor);
    const double workspace = fronts->workspace();
    require_memory(fronts->memory() + workspace,
                   "to factorise the equations of the equilibrium method");
    reserved.emplace(workspace);
    // (Memory that has not been touched does not count as used: another factor
    // would find room in it, too.)
    clear();
  }



  bool
  SparseCholesky::factorize()
  {
    const SharedThreads::Share share;
    return fronts->factorize();
  }



  void
  SparseCholesky::vmult(Vector<double>       &solution,
                        const Vector<double> &right_hand_side) const
  {
    const auto *const order =
      static_cast<const SuiteSparse_long *>(factor->Perm);
    Vector<double> ordered(right_hand_side.size());
    for (unsigned int i = 0; i < ordered.size(); ++i)
      ordered[i] = right_hand_side[order[i]];
    fronts->solve(ordered.begin());
    solution.reinit(right_hand_side.size(), true);
    for (unsigned int i = 0; i < ordered.size(); ++i)
      solution[order[i]] = ordered[i];
  }
} // namespace ElastoPlastic
