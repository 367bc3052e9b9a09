#include "SceneBinding.h"

#include "Arrays.h"
#include "FieldBinding.h"
#include "ModelBinding.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <pybind11/stl.h>

namespace py = pybind11;

namespace palpate
{
namespace
{
using Id = std::optional<int>;

// Adds a structure by one of the C interface's functions; returns its id.
template <typename Function, typename... Given>
int Add(BoundScene& scene, const Id& wanted, const palpate_law& law, Function function,
        Given... given)
{
  const py::gil_scoped_release others;
  const std::lock_guard<std::mutex> lock(scene.Busy);
  const int id = wanted.value_or(scene.LastId + 1);
  Call(function, scene.Handle.get(), id, given..., &law);
  scene.LastId = std::max(scene.LastId, id);
  return id;
}

int AddModel(BoundScene& scene, const BoundModel& model, const Id& id, double stiffness,
             double damping, double staticFriction, double dynamicFriction)
{
  return Add(scene, id, {stiffness, damping, staticFriction, dynamicFriction},
             palpate_scene_add_model, model.Handle.get());
}

int AddField(BoundScene& scene, const BoundField& field, const Id& id, double stiffness,
             double damping, double staticFriction, double dynamicFriction)
{
  return Add(scene, id, {stiffness, damping, staticFriction, dynamicFriction},
             palpate_scene_add_field, field.Handle.get());
}

int AddMesh(BoundScene& scene, const py::object& givenPoints, const py::object& givenTriangles,
            const Id& id, double stiffness, double damping, double staticFriction,
            double dynamicFriction)
{
  const VectorArray points(givenPoints, "points");
  const std::vector<std::int32_t> triangles = TrianglesOf(givenTriangles, points.Count());
  return Add(scene, id, {stiffness, damping, staticFriction, dynamicFriction},
             palpate_scene_add_mesh, points.Data(), points.Count(), triangles.data(),
             triangles.size() / 3);
}

std::unique_ptr<BoundScene> CreateScene(double toolRadius)
{
  auto scene = std::make_unique<BoundScene>();
  Call(palpate_scene_set_tool_radius, scene->Handle.get(), toolRadius);
  return scene;
}

void SetToolRadius(BoundScene& scene, double radius)
{
  const py::gil_scoped_release others;
  const std::lock_guard<std::mutex> lock(scene.Busy);
  Call(palpate_scene_set_tool_radius, scene.Handle.get(), radius);
}

void SetWorkspace(BoundScene& scene, const py::object& center, double scale)
{
  const auto middle = TripleOf(center, "center");
  const py::gil_scoped_release others;
  const std::lock_guard<std::mutex> lock(scene.Busy);
  Call(palpate_scene_set_workspace, scene.Handle.get(), middle.data(), scale);
}

std::unique_ptr<BoundTracker> CreateTracker(BoundScene& scene)
{
  const py::gil_scoped_release others;
  const std::lock_guard<std::mutex> lock(scene.Busy);
  auto tracker = std::make_unique<BoundTracker>();
  tracker->Handle.reset(Call(palpate_tracker_create, scene.Handle.get()));
  return tracker;
}

py::array_t<palpate_contact> Follow(BoundTracker& tracker, const py::object& given)
{
  const VectorArray probes(given, "probes");
  auto results = probes.Results<palpate_contact>();
  palpate_contact* const contacts = results.mutable_data();
  {
    const py::gil_scoped_release others;
    const std::lock_guard<std::mutex> lock(tracker.Busy);
    for (std::size_t i = 0; i < probes.Count(); ++i)
    {
      contacts[i] = {};
      palpate_tracker_follow(tracker.Handle.get(), probes.Data() + 3 * i, contacts + i);
    }
  }
  return results;
}

void Release(BoundTracker& tracker)
{
  const py::gil_scoped_release others;
  const std::lock_guard<std::mutex> lock(tracker.Busy);
  palpate_tracker_release(tracker.Handle.get());
}

void BindTracker(py::module_& module)
{
  py::class_<BoundTracker>(module, "Tracker",
                           "A tool in a scene, moved by the program. The scene may change or end "
                           "afterwards.")
      .def(py::init(&CreateTracker), py::arg("scene"))
      .def("follow", &Follow, py::arg("probes"),
           "Moves the tool along probes (n, 3), mm; returns an array (n,) with the fields\n"
           "id: of the structure touched most deeply; 0 for none, or where a probe is not finite\n"
           "proxy: (3,), mm, where the tool would be if it could not enter that structure\n"
           "normal: (3,), out of it; depth: mm from the probe to the proxy\n"
           "force: (3,), N, of all structures, without damping.")
      .def("release", &Release, "Forgets the last place: the next one is reached from outside.");
  module.attr("contact_dtype") = py::dtype::of<palpate_contact>();
}
} // namespace

void BindScenes(py::module_& module)
{
  PYBIND11_NUMPY_DTYPE(palpate_contact, id, proxy, normal, depth, force);
  py::class_<BoundScene>(module, "Scene",
                         "What is touched, with a sphere as the tool.\n\ntool_radius: mm.")
      .def(py::init(&CreateScene), py::arg("tool_radius") = 1.0)
      .def("add", &AddModel, py::arg("structure"), py::arg("id") = py::none(), py::kw_only(),
           py::arg("stiffness") = 0.5, py::arg("damping") = 0.0, py::arg("static_friction") = 0.0,
           py::arg("dynamic_friction") = 0.0,
           "Adds a Model or a Field and returns its id, above 0; unless given, the next free "
           "one.\n\n"
           "stiffness: N/mm, up to 100; a model that yields has its own. damping: N s/mm, up to "
           "10. Friction: coefficients, up to 10.")
      .def("add", &AddField, py::arg("structure"), py::arg("id") = py::none(), py::kw_only(),
           py::arg("stiffness") = 0.5, py::arg("damping") = 0.0, py::arg("static_friction") = 0.0,
           py::arg("dynamic_friction") = 0.0)
      .def("add_mesh", &AddMesh, py::arg("points"), py::arg("triangles"),
           py::arg("id") = py::none(), py::kw_only(), py::arg("stiffness") = 0.5,
           py::arg("damping") = 0.0, py::arg("static_friction") = 0.0,
           py::arg("dynamic_friction") = 0.0,
           "Adds a closed mesh: points (n, 3), mm, and triangles (m, 3) of indices, "
           "counter-clockwise from outside.")
      .def("set_tool_radius", &SetToolRadius, py::arg("radius"), "mm, up to 100; 0 is a point.")
      .def("set_workspace", &SetWorkspace, py::arg("center"), py::arg("scale") = 1.0,
           "Where the middle of the device's workspace is (3,), mm, and mm of the scene for one of "
           "the hand. Without it a session begins with the whole scene in reach.");
  BindTracker(module);
}
} // namespace palpate
