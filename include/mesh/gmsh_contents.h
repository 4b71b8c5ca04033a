// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mesh_gmsh_contents_h
#define mesh_gmsh_contents_h

#include <deal.II/base/point.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "mesh/gmsh_scanner.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// What a mesh file of Gmsh says, ASCII formats 2.2 and 4.1 (Gmsh reference
  /// manual, "MSH file format").
  ///
  /// deal.II's GridIn reads these formats as well, but it drops the names of
  /// physical groups and trusts the file: a damaged one makes it write outside
  /// its arrays. Here each number is checked as it is read.
  class GmshContents
  {
  public:
    /// Read the file. @throws InputError if it cannot be read or is damaged.
    explicit GmshContents(const std::string &file_name);

    struct Element
    {
      unsigned int              type;         ///< Gmsh's number
      unsigned int              physical_tag; ///< 0: in no physical group
      long                      entity;       ///< of the geometry; 0: unknown
      std::vector<unsigned int> nodes;        ///< indices into nodes
    };

    /// Dimension and number of a geometric entity or a physical group.
    using Tag = std::pair<unsigned int, long>;

    std::map<Tag, std::string> physical_names;
    std::vector<Point<3>>      nodes;
    std::vector<Element>       elements;

  private:
    void
    read_format(GmshScanner &scanner);

    void
    read_section(const std::string &section, GmshScanner &scanner);

    void
    read_physical_names(GmshScanner &scanner);

    void
    read_entities(GmshScanner &scanner);

    void
    read_entity(const unsigned int dimension, GmshScanner &scanner);

    void
    read_nodes(GmshScanner &scanner);

    void
    read_node_block(GmshScanner &scanner);

    /// The number of a physical group without its sign, which tells the
    /// orientation.
    static unsigned int
    read_physical_tag(GmshScanner &scanner);

    void
    add_node(const long tag, GmshScanner &scanner);

    void
    read_elements(GmshScanner &scanner);

    void
    read_element_block(GmshScanner &scanner);

    std::vector<unsigned int>
    read_nodes_of_element(const unsigned int type, GmshScanner &scanner) const;

    std::string                  version;
    std::map<Tag, unsigned int>  physical_tags;
    std::map<long, unsigned int> node_indices;
  };
} // namespace ElastoPlastic

#endif
