// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/utilities.h>

#include <algorithm>

#include "input/entry_effects.h"

namespace ElastoPlastic
{
  namespace EntryReasons
  {
    namespace
    {
      std::string
      joined(const Names &names)
      {
        std::string text;
        for (const std::string &name : names)
          text += (text.empty()         ? "" :
                   name == names.back() ? " or " :
                                          ", ") +
                  name;
        return text;
      }
    } // namespace



    std::vector<double>
    numbers(const EntryValues &values, const std::string &path)
    {
      std::vector<double> result;
      for (const std::string &text :
           dealii::Utilities::split_string_list(values.at(path)))
        result.push_back(dealii::Utilities::string_to_double(text));
      return result;
    }



    Reason
    with(const std::string &path, const Names &allowed)
    {
      return [=](const EntryValues &values) -> std::string {
        for (const std::string &value :
             dealii::Utilities::split_string_list(values.at(path)))
          if (std::find(allowed.begin(), allowed.end(), value) != allowed.end())
            return "";
        return "it is for '" + path + " = " + joined(allowed) +
               "', which is '" + values.at(path) + "'";
      };
    }



    Reason
    without(const std::string &path, const std::string &excluded)
    {
      return [=](const EntryValues &values) -> std::string {
        return values.at(path) == excluded ?
                 "'" + path + "' is '" + excluded + "'" :
                 "";
      };
    }



    Reason
    with_nonzero(const std::string &path)
    {
      return [=](const EntryValues &values) -> std::string {
        for (const double number : numbers(values, path))
          if (number != 0.)
            return "";
        return "'" + path + "' is 0";
      };
    }



    Reason
    without_history()
    {
      return [](const EntryValues &values) -> std::string {
        return values.at("Loading/History").empty() ?
                 "" :
                 "'Loading/History' takes its place";
      };
    }



    Reason
    with_several_steps()
    {
      return [](const EntryValues &values) -> std::string {
        return values.at("Loading/History").empty() &&
                   values.at("Loading/Path").empty() &&
                   values.at("Loading/Number of steps") == "1" ?
                 "there is a single load step" :
                 "";
      };
    }



    Reason
    all(const std::vector<Reason> &reasons)
    {
      return [=](const EntryValues &values) -> std::string {
        for (const Reason &reason : reasons)
          if (std::string why = reason(values); !why.empty())
            return why;
        return "";
      };
    }



    Reason
    always()
    {
      return [](const EntryValues &) {
        return std::string();
      };
    }
  } // namespace EntryReasons
} // namespace ElastoPlastic
