#include "SceneHandle.h"

#include "ContactLimits.h"
#include "ContactTracker.h"
#include "ElasticContactModel.h"
#include "ErrorText.h"
#include "FacetContactModel.h"
#include "FieldContactModel.h"
#include "FieldHandle.h"
#include "ModelHandle.h"
#include "OrganContact.h"

#include <algorithm>
#include <initializer_list>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace palpate
{
namespace
{
// Adds it unless the scene could not be rendered, or its tool not touch it.
int Add(palpate_scene& scene, int id, std::shared_ptr<const ContactModel> model,
        const palpate_law& law, palpate_error* error)
{
  std::vector<TouchStructure>& structures = scene.Scene.Structures;
  const bool isUsed = std::any_of(structures.begin(), structures.end(),
                                  [&](const TouchStructure& other) { return other.Id == id; });
  if (id <= 0 || isUsed)
  {
    SetError(error, "a structure's id is above 0, and no other structure of the scene has it");
    return 0;
  }
  const ContactLaw felt{law.stiffness, law.damping, 0.0};
  const SurfaceFriction friction{law.static_friction, law.dynamic_friction};
  if (Told(ContactLimits::Check(felt, friction), error) == 0)
  {
    return 0;
  }
  structures.push_back(
      {"structure " + std::to_string(id), std::move(model), felt, friction, {}, id});
  const TouchStructure& added = structures.back();
  std::unique_ptr<ContactTracker> tracker;
  const bool isAdded =
      Told(scene.Scene.Check(), error) != 0 &&
      Told(added.Model->MakeTracker(scene.Scene.Tool, added.Friction, tracker), error) != 0;
  if (!isAdded)
  {
    structures.pop_back();
  }
  return isAdded ? 1 : 0;
}

Status ContactOf(const ModelDocument& document, std::shared_ptr<const ContactModel>& contact)
{
  if (const auto* surface = std::get_if<SurfaceModel>(&document.Surface))
  {
    return MakeOrganContact(*surface, contact);
  }
  const auto radial = std::make_shared<const RadialModel>(std::get<RadialModel>(document.Surface));
  return document.Elasticity != nullptr
             ? ElasticContactModel::Make(radial, *document.Elasticity, contact)
             : MakeOrganContact(radial, RadialContactMode::Nearest, contact);
}

// Adds what `make` makes.
template <typename Make>
int AddMade(palpate_scene* scene, int id, const palpate_law* law,
            std::initializer_list<Argument> needed, palpate_error* error, Make make)
{
  if (!AreGiven({{scene, "scene"}, {law, "law"}}, error))
  {
    return 0;
  }
  return Guarded(error, needed,
                 [&]
                 {
                   std::shared_ptr<const ContactModel> contact;
                   return Told(make(contact), error) != 0
                              ? Add(*scene, id, std::move(contact), *law, error)
                              : 0;
                 });
}
} // namespace
} // namespace palpate

using namespace palpate;

palpate_scene* palpate_scene_create(void)
{
  return Guarded(nullptr, {}, [] { return new palpate_scene; });
}

void palpate_scene_free(palpate_scene* scene)
{
  delete scene;
}

int palpate_scene_add_model(palpate_scene* scene, int id, const palpate_model* model,
                            const palpate_law* law, palpate_error* error)
{
  return AddMade(scene, id, law, {{model, "model"}}, error,
                 [&](std::shared_ptr<const ContactModel>& contact)
                 { return ContactOf(model->Document, contact); });
}

int palpate_scene_add_field(palpate_scene* scene, int id, const palpate_field* field,
                            const palpate_law* law, palpate_error* error)
{
  return AddMade(scene, id, law, {{field, "field"}}, error,
                 [&](std::shared_ptr<const ContactModel>& contact)
                 { return FieldContactModel::Make(field->Field, 0, contact); });
}

int palpate_scene_add_mesh(palpate_scene* scene, int id, const double* points, size_t point_count,
                           const int32_t* triangles, size_t triangle_count, const palpate_law* law,
                           palpate_error* error)
{
  return AddMade(scene, id, law,
                 {{points, "points", point_count}, {triangles, "triangles", triangle_count}}, error,
                 [&](std::shared_ptr<const ContactModel>& contact)
                 {
                   std::vector<Vector3> corners;
                   for (std::size_t p = 0; p < point_count; ++p)
                   {
                     corners.push_back(VectorOf(points + 3 * p));
                   }
                   std::vector<FacetTree::Triangle> facets;
                   for (std::size_t t = 0; t < triangle_count; ++t)
                   {
                     const int32_t* of = triangles + 3 * t;
                     facets.push_back({of[0], of[1], of[2]});
                   }
                   return FacetContactModel::Make(corners, facets, contact);
                 });
}

int palpate_scene_set_tool_radius(palpate_scene* scene, double radius, palpate_error* error)
{
  return Guarded(error, {{scene, "scene"}},
                 [&]
                 {
                   const ToolShape tool = ToolShape::Sphere(radius);
                   const int isValid =
                       radius > ContactLimits::ToolRadius
                           ? Told(Status::Failure("a tool's radius is from 0 to 100 mm"), error)
                           : Told(tool.Check(), error);
                   scene->Scene.Tool = isValid != 0 ? tool : scene->Scene.Tool;
                   return isValid;
                 });
}

int palpate_scene_set_workspace(palpate_scene* scene, const double center[3], double scale,
                                palpate_error* error)
{
  if (!AreGiven({{scene, "scene"}, {center, "center"}}, error))
  {
    return 0;
  }
  const Vector3 middle = VectorOf(center);
  if (!middle.allFinite() || !(scale >= ContactLimits::LeastScale) ||
      !(scale <= ContactLimits::LargestScale))
  {
    SetError(error, "a workspace's centre is finite, and its scale is from 0.001 to 1,000");
    return 0;
  }
  scene->Place = palpate_scene::Workspace{middle, scale};
  return 1;
}
