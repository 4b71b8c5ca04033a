// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef base_enum_names_h
#define base_enum_names_h

#include <deal.II/base/patterns.h>

#include <algorithm>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace ElastoPlastic
{
  template <typename Enum>
  using EnumNames = std::vector<std::pair<std::string, Enum>>;

  /// What a user types for the values of an enum, in the order of the
  /// documentation; specialised for every enum that an entry of a parameter
  /// file chooses from. With it, ParameterHandler::add_parameter() reads and
  /// documents variables of that type (and lists of them), and
  /// Patterns::Tools::to_string() puts them into messages: a text becomes an
  /// enum while it is parsed, and nowhere else.
  template <typename Enum>
  inline const EnumNames<Enum> enum_names;
} // namespace ElastoPlastic



namespace dealii::Patterns::Tools
{
  // Constrained, it is preferred to the one by magic_enum, which deal.II has
  // for all enums where it is configured with that.
  template <typename Enum>
#ifdef DEAL_II_WITH_MAGIC_ENUM
  requires std::is_enum_v<Enum>
#endif
    struct Convert<Enum,
                   typename std::enable_if<std::is_enum<Enum>::value>::type>
  {
    static std::unique_ptr<PatternBase>
    to_pattern()
    {
      std::string choices;
      for (const auto &name_and_value : ElastoPlastic::enum_names<Enum>)
        choices += (choices.empty() ? "" : "|") + name_and_value.first;
      return std::make_unique<Selection>(choices);
    }

    static std::string
    to_string(const Enum &value, const PatternBase & = *to_pattern())
    {
      return find([&](const auto &pair) { return pair.second == value; }).first;
    }

    /// @throws ExcNoMatch for a text that is not one of the names.
    static Enum
    to_value(const std::string &text,
             const PatternBase &pattern = *to_pattern())
    {
      AssertThrow(pattern.match(text), ExcNoMatch(text, pattern.description()));
      return find([&](const auto &pair) { return pair.first == text; }).second;
    }

  private:
    template <typename Predicate>
    static const std::pair<std::string, Enum> &
    find(const Predicate &predicate)
    {
      const auto &names = ElastoPlastic::enum_names<Enum>;
      const auto  found = std::find_if(names.begin(), names.end(), predicate);
      AssertThrow(found != names.end(), ExcInternalError());
      return *found;
    }
  };
} // namespace dealii::Patterns::Tools

#endif
