// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef base_nodal_interpolation_h
#define base_nodal_interpolation_h

#include <algorithm>
#include <array>
#include <vector>

namespace ElastoPlastic
{
  /// A sparse matrix that interpolates unknowns. Mostly, the dim unknowns of a
  /// node follow each other, as do those that they are interpolated from, with
  /// the same weights: then they share a row here, which is stored and read
  /// once.
  template <int dim, typename Number>
  class NodalInterpolation
  {
  public:
    struct Entry
    {
      unsigned int index;
      Number       weight;
    };

    /// Adds the row of @p unknown. Those of a node should follow each other.
    void
    add(const unsigned int unknown, const std::vector<Entry> &entries)
    {
      Row &row    = pending[n_pending++];
      row.unknown = unknown;
      row.entries.assign(entries.begin(), entries.end());
      if (n_pending < dim)
        return;
      if (are_of_node(pending))
        {
          of_nodes.add(pending[0]);
          n_pending = 0;
        }
      else
        {
          others.add(pending[0]);
          std::rotate(pending.begin(), pending.begin() + 1, pending.end());
          --n_pending;
        }
    }

    /// To be called after the last row.
    void
    finish()
    {
      for (unsigned int k = 0; k < n_pending; ++k)
        others.add(pending[k]);
      n_pending = 0;
    }

    /// Calls receive(unknown, value) with what is interpolated from the entries
    /// of @p vector.
    template <typename Receive>
    void
    interpolate(const Number *const vector, const Receive &receive) const
    {
      of_nodes.interpolate(vector, receive);
      others.interpolate(vector, receive);
    }

    /// The transpose: adds to the entries of @p vector what they get of the
    /// values give(unknown), in the same order.
    template <typename Give>
    void
    add_transpose(Number *const vector, const Give &give) const
    {
      of_nodes.add_transpose(vector, give);
      others.add_transpose(vector, give);
    }

    /// Calls receive(unknown), in the same order.
    template <typename Receive>
    void
    for_each_unknown(const Receive &receive) const
    {
      of_nodes.for_each_unknown(receive);
      others.for_each_unknown(receive);
    }

    /// Calls receive(unknown, index) for all unknowns that are equal to an
    /// entry.
    template <typename Receive>
    void
    for_each_copy(const Receive &receive) const
    {
      of_nodes.for_each_copy(receive);
      others.for_each_copy(receive);
    }

    /// Calls receive(unknown, index, weight) for all entries.
    template <typename Receive>
    void
    for_each_entry(const Receive &receive) const
    {
      of_nodes.for_each_entry(receive);
      others.for_each_entry(receive);
    }

    unsigned int
    n_unknowns() const
    {
      return dim * of_nodes.unknowns.size() + others.unknowns.size();
    }

  private:
    struct Row
    {
      unsigned int       unknown;
      std::vector<Entry> entries;
    };

    static bool
    are_of_node(const std::array<Row, dim> &rows)
    {
      const Row &first = rows[0];
      for (unsigned int c = 1; c < dim; ++c)
        {
          if (rows[c].unknown != first.unknown + c ||
              rows[c].entries.size() != first.entries.size())
            return false;
          for (unsigned int j = 0; j < first.entries.size(); ++j)
            if (rows[c].entries[j].index != first.entries[j].index + c ||
                rows[c].entries[j].weight != first.entries[j].weight)
              return false;
        }
      return true;
    }

    /// Rows of n unknowns that follow each other, with the first of these; row
    /// k has the entries from row_starts[k] to row_starts[k + 1].
    template <unsigned int n>
    struct Rows
    {
      std::vector<unsigned int> unknowns;
      std::vector<unsigned int> row_starts = {0};
      std::vector<Entry>        entries;

      void
      add(const Row &row)
      {
        unknowns.push_back(row.unknown);
        entries.insert(entries.end(), row.entries.begin(), row.entries.end());
        row_starts.push_back(entries.size());
      }

      template <typename Receive>
      void
      interpolate(const Number *const vector, const Receive &receive) const
      {
        for (unsigned int k = 0; k < unknowns.size(); ++k)
          {
            std::array<Number, n> sums{};
            for (unsigned int j = row_starts[k]; j < row_starts[k + 1]; ++j)
              for (unsigned int c = 0; c < n; ++c)
                sums[c] += entries[j].weight * vector[entries[j].index + c];
            for (unsigned int c = 0; c < n; ++c)
              receive(unknowns[k] + c, sums[c]);
          }
      }

      template <typename Give>
      void
      add_transpose(Number *const vector, const Give &give) const
      {
        for (unsigned int k = 0; k < unknowns.size(); ++k)
          {
            std::array<Number, n> values;
            for (unsigned int c = 0; c < n; ++c)
              values[c] = give(unknowns[k] + c);
            for (unsigned int j = row_starts[k]; j < row_starts[k + 1]; ++j)
              for (unsigned int c = 0; c < n; ++c)
                vector[entries[j].index + c] += entries[j].weight * values[c];
          }
      }

      template <typename Receive>
      void
      for_each_unknown(const Receive &receive) const
      {
        for (const unsigned int first : unknowns)
          for (unsigned int c = 0; c < n; ++c)
            receive(first + c);
      }

      template <typename Receive>
      void
      for_each_copy(const Receive &receive) const
      {
        for (unsigned int k = 0; k < unknowns.size(); ++k)
          if (row_starts[k + 1] == row_starts[k] + 1 &&
              entries[row_starts[k]].weight > Number(1. - 1e-6))
            for (unsigned int c = 0; c < n; ++c)
              receive(unknowns[k] + c, entries[row_starts[k]].index + c);
      }

      template <typename Receive>
      void
      for_each_entry(const Receive &receive) const
      {
        for (unsigned int k = 0; k < unknowns.size(); ++k)
          for (unsigned int j = row_starts[k]; j < row_starts[k + 1]; ++j)
            for (unsigned int c = 0; c < n; ++c)
              receive(unknowns[k] + c, entries[j].index + c, entries[j].weight);
      }
    };

    /// Rows that may turn out to be those of a node.
    std::array<Row, dim> pending;
    unsigned int         n_pending = 0;

    Rows<dim> of_nodes;
    Rows<1>   others;
  };
} // namespace ElastoPlastic

#endif
