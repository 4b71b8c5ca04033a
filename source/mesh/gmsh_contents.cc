// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "base/exceptions.h"
#include "mesh/gmsh_contents.h"
#include "mesh/gmsh_scanner.h"

namespace ElastoPlastic
{
  GmshContents::GmshContents(const std::string &file_name)
    : file_name(file_name)
  {
    GmshScanner scanner(file_name);
    read_format(scanner);
    while (!scanner.at_end())
      {
        const std::string section = scanner.word();
        if (section.size() < 2 || section[0] != '$')
          scanner.fail("there is '" + section +
                       "' where a section like '$Nodes' should begin.");
        read_section(section.substr(1), scanner);
      }
  }



  std::string
  GmshContents::group_name(const unsigned int dimension,
                           const unsigned int tag) const
  {
    const auto        found = physical_names.find({dimension, tag});
    const std::string name =
      found == physical_names.end() ? "" : Utilities::trim(found->second);
    return name.empty() ? std::to_string(tag) : name;
  }



  void
  GmshContents::reject(const std::string &reason) const
  {
    throw InputError("Geometry/File", file_name, reason);
  }



  void
  GmshContents::read_format(GmshScanner &scanner)
  {
    const std::string remedy =
      " Export it from Gmsh as 'Version 4 ASCII' or 'Version 2 ASCII'.";
    if (scanner.at_end())
      scanner.fail("there is nothing: the file is empty.");
    std::string section = scanner.word();
    for (; section == "$Comments"; section = scanner.word())
      scanner.skip_past("$EndComments");
    if (section != "$MeshFormat")
      scanner.fail("'$MeshFormat' is missing, so it is no mesh file of Gmsh." +
                   remedy);
    version = scanner.word();
    if (version != "2.1" && version != "2.2" && version != "4.1")
      scanner.fail("the format is '" + version +
                   "', but only 2.1, 2.2 and 4.1 are read." + remedy);
    if (scanner.word() != "0")
      scanner.fail("the format is binary, but only ASCII is read." + remedy);
    scanner.count();
    scanner.expect("$EndMeshFormat");
  }



  void
  GmshContents::read_section(const std::string &section, GmshScanner &scanner)
  {
    if (section == "PhysicalNames")
      read_physical_names(scanner);
    else if (section == "Entities")
      read_entities(scanner);
    else if (section == "PartitionedEntities")
      read_partitioned_entities(scanner);
    else if (section == "Nodes")
      read_nodes(scanner);
    else if (section == "Elements")
      read_elements(scanner);
    else
      {
        scanner.skip_past("$End" + section);
        return;
      }
    scanner.expect("$End" + section);
  }



  void
  GmshContents::read_physical_names(GmshScanner &scanner)
  {
    for (unsigned int n = scanner.count(); n > 0; --n)
      {
        const unsigned int dimension        = scanner.count();
        const unsigned int tag              = read_physical_tag(scanner);
        physical_names[Tag(dimension, tag)] = scanner.word();
      }
  }



  void
  GmshContents::read_entities(GmshScanner &scanner)
  {
    for_each_entity(scanner, [&](const unsigned int dimension) {
      read_entity(dimension, scanner);
    });
  }



  void
  GmshContents::read_partitioned_entities(GmshScanner &scanner)
  {
    scanner.count();
    for (unsigned int n_ghosts = scanner.count(); n_ghosts > 0; --n_ghosts)
      {
        scanner.integer();
        scanner.integer();
      }
    for_each_entity(scanner, [&](const unsigned int dimension) {
      read_part_of_entity(dimension, scanner);
    });
  }



  void
  GmshContents::for_each_entity(
    GmshScanner                                   &scanner,
    const std::function<void(const unsigned int)> &read) const
  {
    std::vector<unsigned int> n_entities;
    for (unsigned int dimension = 0; dimension <= 3; ++dimension)
      n_entities.push_back(scanner.count());
    for (unsigned int dimension = 0; dimension <= 3; ++dimension)
      for (unsigned int n = n_entities[dimension]; n > 0; --n)
        read(dimension);
  }



  void
  GmshContents::read_entity(const unsigned int dimension, GmshScanner &scanner)
  {
    const long number = scanner.integer();
    const Tag  tag(dimension, number);
    entities[tag] = {read_group_of_entity(tag, scanner), number};
  }



  void
  GmshContents::read_part_of_entity(const unsigned int dimension,
                                    GmshScanner       &scanner)
  {
    const Tag          part(dimension, scanner.integer());
    const unsigned int dimension_of_whole = scanner.count();
    const Tag          whole(dimension_of_whole, scanner.integer());
    for (unsigned int n_partitions = scanner.count(); n_partitions > 0;
         --n_partitions)
      scanner.integer();

    // (What parts have in common is a part of something larger.)
    const unsigned int group = read_group_of_entity(part, scanner);
    const auto         found = entities.find(whole);
    entities[part]           = {group, part.second};
    if (dimension_of_whole == dimension && found != entities.end())
      entities[part] = found->second;
  }



  unsigned int
  GmshContents::read_group_of_entity(const Tag   &entity,
                                     GmshScanner &scanner) const
  {
    const auto [dimension, number]   = entity;
    const unsigned int n_coordinates = (dimension == 0 ? 3 : 6);
    for (unsigned int i = 0; i < n_coordinates; ++i)
      scanner.number();

    const unsigned int n_groups = scanner.count();
    if (n_groups > 1)
      scanner.fail("the entity " + std::to_string(number) + " of dimension " +
                   std::to_string(dimension) +
                   " is in several physical groups, but one is allowed.");
    const unsigned int group = (n_groups == 1 ? read_physical_tag(scanner) : 0);

    if (dimension > 0)
      for (unsigned int n = scanner.count(); n > 0; --n)
        scanner.integer();
    return group;
  }



  void
  GmshContents::read_nodes(GmshScanner &scanner)
  {
    if (version != "4.1")
      {
        for (unsigned int n = scanner.count(); n > 0; --n)
          {
            const long tag = scanner.integer();
            add_node(tag, scanner);
          }
        return;
      }

    const unsigned int n_blocks = scanner.count();
    const unsigned int n_nodes  = scanner.count();
    scanner.integer();
    scanner.integer();
    for (unsigned int block = 0; block < n_blocks; ++block)
      read_node_block(scanner);
    if (nodes.size() != n_nodes)
      scanner.fail("the nodes end, and there are " +
                   std::to_string(nodes.size()) + " of them instead of " +
                   std::to_string(n_nodes) + ".");
  }



  void
  GmshContents::read_node_block(GmshScanner &scanner)
  {
    const unsigned int dimension = scanner.count();
    scanner.integer();
    const bool         parametric = (scanner.count() != 0);
    const unsigned int n_nodes    = scanner.count();

    std::vector<long> tags;
    for (unsigned int n = 0; n < n_nodes; ++n)
      tags.push_back(scanner.integer());
    for (const long tag : tags)
      {
        add_node(tag, scanner);
        if (parametric)
          for (unsigned int d = 0; d < dimension; ++d)
            scanner.number();
      }
  }



  // deal.II keeps the largest number of 32 bits for what is in no group.
  unsigned int
  GmshContents::read_physical_tag(GmshScanner &scanner)
  {
    constexpr long largest = std::numeric_limits<unsigned int>::max() - 1;
    const long     tag     = scanner.integer();
    if (tag > largest || tag < -largest)
      scanner.fail("a physical group has the number " + std::to_string(tag) +
                   ", but at most " + std::to_string(largest) +
                   " is allowed. Give it another number in Gmsh.");
    return std::abs(tag);
  }



  void
  GmshContents::add_node(const long tag, GmshScanner &scanner)
  {
    if (!node_indices.emplace(tag, nodes.size()).second)
      scanner.fail("there is a second node with the number " +
                   std::to_string(tag) + ".");
    nodes.emplace_back();
    for (unsigned int d = 0; d < 3; ++d)
      nodes.back()[d] = scanner.number();
  }



  void
  GmshContents::read_elements(GmshScanner &scanner)
  {
    if (version == "4.1")
      {
        const unsigned int n_blocks   = scanner.count();
        const unsigned int n_elements = scanner.count();
        scanner.integer();
        scanner.integer();
        for (unsigned int block = 0; block < n_blocks; ++block)
          read_element_block(scanner);
        if (elements.size() != n_elements)
          scanner.fail("the elements end, and there are " +
                       std::to_string(elements.size()) +
                       " of them instead of " + std::to_string(n_elements) +
                       ".");
        return;
      }

    for (unsigned int n = scanner.count(); n > 0; --n)
      {
        scanner.integer();
        const unsigned int type   = scanner.count();
        const unsigned int n_tags = scanner.count();
        const unsigned int physical_tag =
          n_tags > 0 ? read_physical_tag(scanner) : 0;
        const long entity = n_tags > 1 ? scanner.integer() : 0;
        for (unsigned int i = 2; i < n_tags; ++i)
          scanner.integer();
        read_element(type, {physical_tag, entity}, scanner);
      }
  }



  void
  GmshContents::read_element_block(GmshScanner &scanner)
  {
    const unsigned int dimension  = scanner.count();
    const long         number     = scanner.integer();
    const unsigned int type       = scanner.count();
    const unsigned int n_elements = scanner.count();

    const auto   found = entities.find(Tag(dimension, number));
    const Entity entity =
      found == entities.end() ? Entity{0, number} : found->second;
    for (unsigned int n = 0; n < n_elements; ++n)
      {
        scanner.integer();
        read_element(type, entity, scanner);
      }
  }



  void
  GmshContents::read_element(const unsigned int number_of_type,
                             const Entity      &entity,
                             GmshScanner       &scanner)
  {
    const GmshElementType    &type = gmsh_element_type(number_of_type, scanner);
    std::vector<unsigned int> indices;
    for (unsigned int i = 0; i < type.n_nodes; ++i)
      {
        const long tag   = scanner.integer();
        const auto index = node_indices.find(tag);
        if (index == node_indices.end())
          scanner.fail("an element uses the node " + std::to_string(tag) +
                       ", which does not exist.");
        if (std::find(indices.begin(), indices.end(), index->second) !=
            indices.end())
          scanner.fail("an element uses the node " + std::to_string(tag) +
                       " twice.");
        indices.push_back(index->second);
      }
    indices.resize(type.n_corners);
    is_of_second_order |= (type.number_of_first_order != number_of_type);
    elements.push_back({type.number_of_first_order,
                        entity.physical_tag,
                        entity.number,
                        indices});
  }
} // namespace ElastoPlastic
