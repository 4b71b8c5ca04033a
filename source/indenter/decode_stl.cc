// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <boost/algorithm/string/case_conv.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <locale>
#include <string>

#include "indenter/height_file.h"

namespace ElastoPlastic
{
  using namespace std::string_literals;

  namespace
  {
    /// On every rank, they take about 240 MB.
    constexpr std::size_t n_facets_max = 2'000'000;

    /// Products of three coordinates stay finite.
    constexpr double largest_coordinate = 1e100;



    void
    check_n_facets(const HeightFile &file, const std::size_t n_facets)
    {
      if (n_facets > n_facets_max)
        file.reject(
          "this surface has more than 2*10^6 triangles. Choose a "
          "coarser resolution.");
    }



    std::string
    in_small_letters(const std::string &text)
    {
      return boost::algorithm::to_lower_copy(text, std::locale::classic());
    }



    /// The text of a file, word by word, in small letters.
    class Words
    {
    public:
      explicit Words(const HeightFile &file)
        : file(file)
        , text(in_small_letters(file.text()))
      {}

      /// The next word; empty at the end of the file.
      std::string
      next()
      {
        static const char *const space = " \t\r\n\v\f";
        const std::size_t        begin =
          std::min(text.find_first_not_of(space, end), text.size());
        end = std::min(text.find_first_of(space, begin), text.size());
        return text.substr(begin, end - begin);
      }

      void
      expect(const std::string &word)
      {
        if (next() != word)
          reject("should have '" + word + "' here");
      }

      double
      next_coordinate()
      {
        const std::string word   = next();
        char             *stop   = nullptr;
        const double      number = std::strtod(word.c_str(), &stop);
        if (word.empty() || stop != word.c_str() + word.size() ||
            !(std::abs(number) <= largest_coordinate))
          reject("should have a coordinate here, a number of at most 1e100");
        return number;
      }

      /// A name follows that is of no interest.
      void
      skip_line()
      {
        end = std::min(text.find('\n', end), text.size());
      }

      [[noreturn]] void
      reject(const std::string &what) const
      {
        const auto line =
          1 + std::count(text.begin(), text.begin() + end, '\n');
        file.reject("line " + std::to_string(line) + " of this STL text " +
                    what + ". It is damaged or truncated.");
      }

    private:
      const HeightFile &file;
      const std::string text;
      std::size_t       end = 0; ///< of the last word
    };



    /// What follows the word "facet".
    Facet
    next_facet(Words &words)
    {
      words.expect("normal");
      for (unsigned int d = 0; d < 3; ++d)
        words.next();
      words.expect("outer");
      words.expect("loop");
      Facet facet;
      for (Point<3> &corner : facet)
        {
          words.expect("vertex");
          for (unsigned int d = 0; d < 3; ++d)
            corner[d] = words.next_coordinate();
        }
      words.expect("endloop");
      words.expect("endfacet");
      return facet;
    }



    std::vector<Facet>
    decode_text(const HeightFile &file)
    {
      std::vector<Facet> facets;
      Words              words(file);
      for (std::string word = words.next(); !word.empty(); word = words.next())
        {
          if (word != "solid")
            words.reject("should have 'solid' here");
          words.skip_line();
          for (word = words.next(); word == "facet"; word = words.next())
            {
              facets.push_back(next_facet(words));
              check_n_facets(file, facets.size());
            }
          if (word != "endsolid")
            words.reject("should have 'facet' or 'endsolid' here");
          words.skip_line();
        }
      return facets;
    }



    // The form has little-endian numbers: a header of 80 bytes, the number of
    // facets in 4, and for each normal and corners in 12 times 4 and 2 others.
    constexpr std::size_t header_size = 84, facet_size = 50;



    std::uint32_t
    integer_at(const std::string &bytes, const std::size_t position)
    {
      std::uint32_t result = 0;
      for (unsigned int i = 4; i-- > 0;)
        result = 256 * result + static_cast<unsigned char>(bytes[position + i]);
      return result;
    }



    float
    number_at(const std::string &bytes, const std::size_t position)
    {
      const std::uint32_t bits = integer_at(bytes, position);
      float               result;
      static_assert(sizeof(result) == sizeof(bits), "IEEE 754");
      std::memcpy(&result, &bits, sizeof(result));
      return result;
    }



    bool
    is_binary(const std::string &bytes)
    {
      return bytes.size() >= header_size &&
             bytes.size() - header_size ==
               facet_size * std::size_t(integer_at(bytes, header_size - 4));
    }



    std::vector<Facet>
    decode_binary(const HeightFile &file)
    {
      const std::size_t n_facets =
        (file.content.size() - header_size) / facet_size;
      check_n_facets(file, n_facets);
      std::vector<Facet> facets(n_facets);
      for (std::size_t i = 0; i < n_facets; ++i)
        for (unsigned int v = 0; v < 3; ++v)
          for (unsigned int d = 0; d < 3; ++d)
            {
              const double coordinate =
                number_at(file.content,
                          header_size + i * facet_size + 4 * (3 + 3 * v + d));
              if (!std::isfinite(coordinate))
                file.reject("triangle " + std::to_string(i + 1) +
                            " of this binary STL surface has a coordinate "
                            "that is not finite. It is damaged.");
              facets[i][v][d] = coordinate;
            }
      return facets;
    }



    /// (The header of a binary file may begin so, too.)
    bool
    is_text(const HeightFile &file)
    {
      return in_small_letters(file.text().substr(0, 5)) == "solid" &&
             file.content.find('\0') == std::string::npos;
    }



    /// How many times as far from the origin as it is wide a surface may be, so
    /// that coordinates in single precision keep four digits of it.
    constexpr double largest_offset = 1000.;



    void
    check_offset(const HeightFile &file, const std::vector<Facet> &facets)
    {
      Point<3> lower = facets[0][0], upper = lower;
      for (const Facet &facet : facets)
        for (const Point<3> &corner : facet)
          for (unsigned int d = 0; d < 3; ++d)
            {
              lower[d] = std::min(lower[d], corner[d]);
              upper[d] = std::max(upper[d], corner[d]);
            }
      const double size = std::max(upper[0] - lower[0], upper[1] - lower[1]);
      for (unsigned int d = 0; d < 3; ++d)
        if (std::max(-lower[d], upper[d]) > largest_offset * size)
          file.reject("the "s + "xyz"[d] +
                      " coordinates of this STL surface are "
                      "more than 1000 times its size: its digits are lost in "
                      "theirs. Move it to the origin, which comes to "
                      "'Indenter/Position'.");
    }



    bool
    is_vertical(const Facet &facet)
    {
      const Tensor<1, 3> a = facet[1] - facet[0], b = facet[2] - facet[0];
      const double       rounding =
        1e-14 * std::max(a.norm_square(), b.norm_square());
      return !(std::abs(a[0] * b[1] - a[1] * b[0]) > rounding);
    }
  } // namespace



  std::vector<Facet>
  decode_stl(const HeightFile &file)
  {
    const bool binary = is_binary(file.content);
    if (!binary && !is_text(file))
      file.reject(
        "its content is not an STL surface: a text begins with "
        "'solid', and a binary file of N triangles has 84 + 50 N "
        "bytes, where N is its own bytes 81 to 84. It is truncated, "
        "or of another format.");
    std::vector<Facet> facets =
      binary ? decode_binary(file) : decode_text(file);
    facets.erase(std::remove_if(facets.begin(), facets.end(), is_vertical),
                 facets.end());
    if (facets.empty())
      file.reject(
        "this STL surface has no triangle that is not vertical. "
        "The last coordinate points up.");
    check_offset(file, facets);
    return facets;
  }
} // namespace ElastoPlastic
