#include "SessionBinding.h"

#include "Arrays.h"
#include "Results.h"
#include "SceneBinding.h"

#include <memory>
#include <string>

namespace py = pybind11;

namespace palpate
{
namespace
{
// The handle, while nobody else uses the session.
class OpenSession
{
public:
  explicit OpenSession(BoundSession& session) : Lock(session.Busy), Handle(session.Handle.get())
  {
    if (this->Handle == nullptr)
    {
      throw CallError("the session is closed");
    }
  }
  operator palpate_session*() const { return this->Handle; }

private:
  const py::gil_scoped_release Others; // first: the lock is waited for without the interpreter
  const std::lock_guard<std::mutex> Lock;
  palpate_session* Handle;
};

std::unique_ptr<BoundSession> OpenNamedSession(const std::string& device)
{
  const py::gil_scoped_release others;
  auto session = std::make_unique<BoundSession>();
  session->Handle.reset(Call(palpate_session_open, device.c_str()));
  return session;
}

void CloseSession(BoundSession& session)
{
  const py::gil_scoped_release others;
  const std::lock_guard<std::mutex> lock(session.Busy);
  session.Handle.reset();
}

void ShowScene(BoundSession& session, BoundScene& scene, bool isContinuing)
{
  const OpenSession open(session);
  const std::lock_guard<std::mutex> lock(scene.Busy);
  Call(palpate_session_show, static_cast<palpate_session*>(open), scene.Handle.get(),
       isContinuing ? 1 : 0);
}

py::object ReadState(BoundSession& session)
{
  palpate_state state{};
  if (palpate_session_read(OpenSession(session), &state) == 0)
  {
    throw CallError("the session shows no scene yet");
  }
  return Result("State", static_cast<double>(state.time) * 1e-9, state.tick,
                Numbers(3, state.probe), Numbers(3, state.proxy), Numbers(3, state.force),
                state.buttons, state.has_sample != 0, state.id, state.depth, state.patch,
                state.is_estimate != 0, state.is_armed != 0, state.is_ramping != 0);
}

std::string ProblemOf(BoundSession& session)
{
  const OpenSession open(session);
  return palpate_session_problem(open); // copied before another thread's call
}

bool LeadHand(BoundSession& session, const py::object& given)
{
  const auto place = TripleOf(given, "place");
  return palpate_session_lead_hand(OpenSession(session), place.data()) != 0;
}
} // namespace

void BindSessions(py::module_& module)
{
  py::class_<BoundSession>(
      module, "Session",
      "A haptic device and a servo thread at 1 kHz, with limited forces that "
      "are off after any fault. Use it in a `with` statement, in the main thread.\n\n"
      "device: 'simulated' or 'falcon'.")
      .def(py::init(&OpenNamedSession), py::arg("device") = "simulated")
      .def("__enter__", [](py::object self) { return self; })
      .def("__exit__", [](BoundSession& session, const py::args&) { CloseSession(session); })
      .def("close", &CloseSession, "0 N, then closes the device.")
      .def("show", &ShowScene, py::arg("scene"), py::arg("is_continuing") = false,
           "Renders a scene: forces fade in, or with `is_continuing` structures with the same id "
           "carry on.")
      .def("read", &ReadState, "The newest tick. Call it ten times a second or more often.")
      .def_property_readonly("problem", &ProblemOf,
                             "Why forces are off and what to do; empty while they are on.")
      .def(
          "stop_force",
          [](BoundSession& session) { palpate_session_stop_force(OpenSession(session)); },
          "0 N from the next tick on, until forces are allowed again.")
      .def(
          "allow_force",
          [](BoundSession& session) { palpate_session_allow_force(OpenSession(session)); },
          "Allows forces again, which also ends a fault.")
      .def("lead_hand", &LeadHand, py::arg("place"),
           "Leads a simulated hand to a place (3,), mm; False, without effect, for a real one.");
}
} // namespace palpate
