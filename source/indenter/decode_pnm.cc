// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <string>

#include "indenter/height_file.h"

namespace ElastoPlastic
{
  namespace
  {
    /// A place in the file that moves on as numbers are read.
    class Scanner
    {
    public:
      Scanner(const HeightFile &file, const std::size_t start)
        : file(file)
        , position(start)
      {}

      /// The next number in decimal digits, of at most nine of them.
      unsigned int
      next_integer()
      {
        skip_space_and_comments();
        unsigned int value = next_digit();
        for (unsigned int n_digits = 1; is_digit(); ++n_digits)
          {
            if (n_digits == 9)
              file.reject(
                "this image contains a number with more than nine "
                "digits. It is damaged.");
            value = 10 * value + next_digit();
          }
        return value;
      }

      /// The next digit; those of a plain PBM need no space between them.
      unsigned int
      next_bit()
      {
        skip_space_and_comments();
        const unsigned int bit = next_digit();
        if (bit > 1)
          file.reject("this PBM image contains a digit other than 0 and 1.");
        return bit;
      }

      unsigned int
      next_byte()
      {
        expect(1);
        return static_cast<unsigned char>(file.content[position++]);
      }

      /// Reject a file that ends earlier than @p n_bytes from here.
      void
      expect(const std::size_t n_bytes) const
      {
        if (file.content.size() < position + n_bytes)
          file.reject(
            "the file ends before its last pixel. It is truncated, "
            "or the size in its header is wrong.");
      }

    private:
      bool
      is_digit() const
      {
        return position < file.content.size() &&
               std::isdigit(static_cast<unsigned char>(file.content[position]));
      }

      unsigned int
      next_digit()
      {
        expect(1);
        if (!is_digit())
          file.reject("byte " + std::to_string(position) +
                      " of this image is not the digit that should be there.");
        return next_byte() - '0';
      }

      void
      skip_space_and_comments()
      {
        const std::string &text = file.content;
        while (position < text.size())
          if (text[position] == '#')
            position =
              std::min(text.find_first_of("\r\n", position), text.size());
          else if (std::isspace(static_cast<unsigned char>(text[position])))
            ++position;
          else
            return;
      }

      const HeightFile &file;
      std::size_t       position;
    };



    /// What the header says.
    struct Header
    {
      Header(const HeightFile &file, Scanner &scanner)
        : type(file.content[1])
        , width(scanner.next_integer())
        , height(scanner.next_integer())
        , largest(is_bitmap() ? 1 : scanner.next_integer())
      {
        file.check_n_pixels(width, height);
        if (largest == 0 || largest > 65535)
          file.reject("the header of this image gives the largest grey as " +
                      std::to_string(largest) +
                      ". It must lie between 1 and 65535.");
        if (!is_plain())
          scanner.next_byte(); // exactly one space before the pixels
      }

      bool
      is_bitmap() const
      {
        return type == '1' || type == '4';
      }

      bool
      is_plain() const
      {
        return type == '1' || type == '2';
      }

      /// The least size of a row in the file.
      std::size_t
      n_bytes_per_row() const
      {
        if (is_plain())
          return width;
        return is_bitmap() ? (width + 7) / 8 : (largest < 256 ? 1 : 2) * width;
      }

      const char         type;
      const unsigned int width, height, largest;
    };



    /// The sample of the next pixel. @p byte holds the pixels of a raw bitmap
    /// from one call to the next.
    unsigned int
    next_sample(Scanner           &scanner,
                const Header      &header,
                const unsigned int column,
                unsigned int      &byte)
    {
      switch (header.type)
        {
          case '1':
            return scanner.next_bit();
          case '2':
            return scanner.next_integer();
          case '4':
            if (column % 8 == 0)
              byte = scanner.next_byte();
            return (byte >> (7 - column % 8)) & 1u;
          default:
            byte = scanner.next_byte();
            return header.largest < 256 ? byte :
                                          256 * byte + scanner.next_byte();
        }
    }
  } // namespace



  Table<2, double>
  decode_pnm(const HeightFile &file)
  {
    Scanner      scanner(file, 2);
    const Header header(file, scanner);
    scanner.expect(header.n_bytes_per_row() * header.height);

    Table<2, double> greys(header.height, header.width);
    unsigned int     byte = 0;
    for (unsigned int row = 0; row < header.height; ++row)
      for (unsigned int column = 0; column < header.width; ++column)
        {
          const unsigned int sample =
            next_sample(scanner, header, column, byte);
          if (sample > header.largest)
            file.reject("this image contains the grey " +
                        std::to_string(sample) +
                        ", more than the largest that its header allows, " +
                        std::to_string(header.largest) + ".");
          const double grey = sample / double(header.largest);
          greys(row, column) =
            header.is_bitmap() ? 1 - grey : grey; // 1 is black
        }
    return greys;
  }
} // namespace ElastoPlastic
