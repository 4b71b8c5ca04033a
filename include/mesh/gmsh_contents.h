// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef mesh_gmsh_contents_h
#define mesh_gmsh_contents_h

#include <deal.II/base/point.h>

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "mesh/gmsh_scanner.h"

namespace ElastoPlastic
{
  using namespace dealii;

  /// What a mesh file of Gmsh says, ASCII formats 2.1, 2.2 and 4.1 (Gmsh
  /// reference manual, "MSH file format"). Elements of second order are read as
  /// those of first order with the same corners. What a partitioned mesh says
  /// about its parts is not read: elements belong to the entities that have
  /// been divided.
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
      std::vector<unsigned int> nodes;        ///< corners, indices into nodes
    };

    /// Dimension and number of a geometric entity or a physical group.
    using Tag = std::pair<unsigned int, long>;

    /// The name of a physical group, or its number if it has none.
    std::string
    group_name(const unsigned int dimension, const unsigned int tag) const;

    /// @throws InputError that names the file; @p reason completes the sentence
    /// "..., but".
    [[noreturn]] void
    reject(const std::string &reason) const;

    std::vector<Point<3>> nodes;
    std::vector<Element>  elements;

    /// Whether some elements have had more nodes than their corners.
    bool is_of_second_order = false;

  private:
    /// A geometric entity as it was before the mesh was partitioned.
    struct Entity
    {
      unsigned int physical_tag;
      long         number;
    };

    void
    read_format(GmshScanner &scanner);

    void
    read_section(const std::string &section, GmshScanner &scanner);

    void
    read_physical_names(GmshScanner &scanner);

    void
    read_entities(GmshScanner &scanner);

    void
    read_partitioned_entities(GmshScanner &scanner);

    /// Reads the entities of all dimensions, each by @p read.
    void
    for_each_entity(GmshScanner                                   &scanner,
                    const std::function<void(const unsigned int)> &read) const;

    void
    read_entity(const unsigned int dimension, GmshScanner &scanner);

    void
    read_part_of_entity(const unsigned int dimension, GmshScanner &scanner);

    /// The number of the physical group, 0 if there is none.
    unsigned int
    read_group_of_entity(const Tag &entity, GmshScanner &scanner) const;

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

    /// An element of Gmsh's type of this number, whose nodes come next.
    void
    read_element(const unsigned int number_of_type,
                 const Entity      &entity,
                 GmshScanner       &scanner);

    const std::string            file_name;
    std::string                  version;
    std::map<Tag, std::string>   physical_names;
    std::map<Tag, Entity>        entities;
    std::map<long, unsigned int> node_indices;
  };
} // namespace ElastoPlastic

#endif
