#include "SessionHandle.h"

#include "ErrorText.h"
#include "OpenBuiltInDevice.h"
#include "SceneHandle.h"

#include <cstddef>
#include <memory>
#include <utility>

namespace palpate
{
namespace
{
WorkspaceFrame PlaceOf(const palpate_session& session, const palpate_scene& scene)
{
  WorkspaceFrame frame =
      session.Session.IsRunning()
          ? session.Session.Frame()
          : WorkspaceFrame::Around(scene.Scene, session.Session.Device().Capabilities());
  if (scene.Place)
  {
    frame.CenterWorld = scene.Place->CenterWorld;
    frame.Scale = scene.Place->Scale;
  }
  return frame;
}
} // namespace
} // namespace palpate

using namespace palpate;

const char* palpate_version(void)
{
  return PALPATE_VERSION;
}

int palpate_api_version(void)
{
  return PALPATE_API_VERSION;
}

palpate_session* palpate_session_open(const char* device, palpate_error* error)
{
  return Guarded(error, {{device, "device"}},
                 [&]() -> palpate_session*
                 {
                   auto session = std::make_unique<palpate_session>();
                   std::unique_ptr<HapticDevice> opened;
                   if (Told(OpenBuiltInDevice(device, session->Clock, opened), error) == 0)
                   {
                     return nullptr;
                   }
                   session->Session.Open(std::move(opened), {});
                   return session.release();
                 });
}

void palpate_session_free(palpate_session* session)
{
  delete session;
}

int palpate_session_show(palpate_session* session, const palpate_scene* scene, int is_continuing,
                         palpate_error* error)
{
  return Guarded(error, {{session, "session"}, {scene, "scene"}},
                 [&]
                 {
                   TouchSession& touch = session->Session;
                   const WorkspaceFrame frame = PlaceOf(*session, *scene);
                   const SceneEntry entry =
                       is_continuing != 0 ? SceneEntry::Continuing : SceneEntry::FadeIn;
                   const int isShown =
                       Told(touch.IsRunning() ? touch.Publish(scene->Scene, frame, entry)
                                              : touch.Start(scene->Scene, frame),
                            error);
                   if (isShown != 0)
                   {
                     session->Ids.clear();
                     for (const TouchStructure& structure : scene->Scene.Structures)
                     {
                       session->Ids.push_back(structure.Id);
                     }
                   }
                   return isShown;
                 });
}

int palpate_session_read(palpate_session* session, palpate_state* state)
{
  return Guarded(nullptr, {{session, "session"}, {state, "state"}},
                 [&]
                 {
                   if (!session->Session.IsRunning())
                   {
                     return 0;
                   }
                   const TouchState& newest = session->Session.Poll().Newest;
                   *state = {};
                   state->time = newest.Tick.Started;
                   state->tick = newest.Tick.Number;
                   Copy(newest.ProbeWorld, state->probe);
                   Copy(newest.ProxyWorld, state->proxy);
                   Copy(newest.ForceWorld, state->force);
                   state->buttons = newest.Sample.Buttons;
                   state->has_sample = newest.HasSample ? 1 : 0;
                   const auto touched = static_cast<std::size_t>(newest.Structure);
                   state->id = touched < session->Ids.size() ? session->Ids[touched] : 0;
                   state->depth = newest.Depth;
                   state->patch = newest.PatchRadius;
                   state->is_estimate = newest.IsBeyondLinear ? 1 : 0;
                   state->is_armed = newest.Safety.IsArmed ? 1 : 0;
                   state->is_ramping = newest.Safety.IsRamping ? 1 : 0;
                   return 1;
                 });
}

const char* palpate_session_problem(palpate_session* session)
{
  if (session == nullptr)
  {
    return "";
  }
  Guarded(nullptr, {},
          [&]
          {
            session->Problem.clear();
            if (session->Session.IsRunning())
            {
              const SafetyReport& safety = session->Session.Poll().Newest.Safety;
              session->Problem = session->Session.Device().Problem();
              if (session->Problem.empty() && safety.Fault != SafetyFault::None)
              {
                session->Problem = Describe(safety.Fault, safety.WillResume);
              }
            }
            return 1;
          });
  return session->Problem.c_str();
}

void palpate_session_stop_force(palpate_session* session)
{
  if (session != nullptr && session->Session.IsRunning())
  {
    session->Session.Loop().SwitchOff();
  }
}

void palpate_session_allow_force(palpate_session* session)
{
  if (session != nullptr && session->Session.IsRunning())
  {
    session->Session.Loop().Rearm();
  }
}

int palpate_session_lead_hand(palpate_session* session, const double place[3])
{
  if (session == nullptr || place == nullptr)
  {
    return 0;
  }
  const Vector3 goal = VectorOf(place);
  return goal.allFinite() && session->Session.IsRunning() &&
                 session->Session.LeadHand(session->Session.Frame().ToDevice(goal))
             ? 1
             : 0;
}
