// SPDX-FileCopyrightText: The ElastoPlasticContact authors
// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef indenter_indenter_parameters_h
#define indenter_indenter_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

#include "base/enum_names.h"
#include "indenter/indenter.h"

namespace ElastoPlastic
{
  using namespace dealii;



  /// What an indenter's surface lets a perfectly plastic body do at its limit.
  enum class SurfaceFinish
  {
    smooth, ///< slide without shear stress
    rough   ///< not slide: any shear stress that the body bears
  };

  template <>
  inline const EnumNames<SurfaceFinish> enum_names<SurfaceFinish> = {
    {"smooth", SurfaceFinish::smooth}, {"rough", SurfaceFinish::rough}};



  /// Which heights of an image or matrix touch first; see "Side down".
  enum class SideDown
  {
    dark, ///< and low
    light ///< and high
  };

  template <>
  inline const EnumNames<SideDown> enum_names<SideDown> = {
    {"dark", SideDown::dark}, {"light", SideDown::light}};



  /// The entries of the section "Indenter": shape and place of the rigid body.
  /// In two dimensions each shape is its section y = 0.
  struct IndenterParameters
  {
    std::string         type            = "sphere";
    double              radius          = 1;
    double              semi_apex_angle = 70.3; ///< degrees
    unsigned int        n_faces    = 4;  ///< of a pyramid, as are the next four
    double              face_angle = 68; ///< degrees
    double              rotation   = 0;  ///< degrees
    double              rounding_radius   = 0;
    double              truncation        = 0;
    std::vector<double> half_widths       = {1};
    std::vector<double> area_coefficients = {24.5};
    std::string         expression        = "(x^2 + y^2)/2";
    std::string         file;
    std::vector<double> size; ///< one per horizontal direction
    double              height_scale = 1;
    double              length_scale = 1;
    SideDown            side_down    = SideDown::dark;
    std::vector<double> position; ///< horizontal; empty stands for the origin
    double              initial_gap = 0;
    double              reach       = 0; ///< 0: as far as the shape goes
    SurfaceFinish       surface     = SurfaceFinish::smooth;

    void
    add_parameters(ParameterHandler &prm);

    bool
    is_present() const
    {
      return type != "none";
    }

    /// What concerns all shapes; the rest shows when make_indenter() reads it.
    /// @throws InputError for the first value that is not allowed.
    void
    check(const unsigned int dim) const;

  private:
    void
    check_pyramid() const;
  };



  /// All values of the entry "Type", separated by '|'.
  std::string
  indenter_types();

  /// The indenter that the parameters describe, without a shape for type
  /// "none". The parameters must have passed their check. Reads the file that
  /// they name, if any. @throws InputError for what is wrong in an expression
  /// or a file, and for lists that do not fit the shape.
  template <int dim>
  PlacedIndenter<dim>
  make_indenter(const IndenterParameters &parameters);
} // namespace ElastoPlastic

#endif
