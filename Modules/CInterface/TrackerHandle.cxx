#include "TrackerHandle.h"

#include "ElasticForce.h"
#include "ErrorText.h"
#include "SceneHandle.h"

#include <utility>

using namespace palpate;

palpate_tracker* palpate_tracker_create(const palpate_scene* scene, palpate_error* error)
{
  return Guarded(
      error, {{scene, "scene"}},
      [&]() -> palpate_tracker*
      {
        auto made = std::make_unique<palpate_tracker>();
        for (const TouchStructure& structure : scene->Scene.Structures)
        {
          std::unique_ptr<ContactTracker> tracker;
          const Status status =
              structure.Model->MakeTracker(scene->Scene.Tool, structure.Friction, tracker);
          if (Told(status, error) == 0)
          {
            return nullptr;
          }
          made->Structures.push_back({structure.Id, structure.Law.Stiffness, std::move(tracker)});
        }
        return made.release();
      });
}

void palpate_tracker_free(palpate_tracker* tracker)
{
  delete tracker;
}

int palpate_tracker_follow(palpate_tracker* tracker, const double probe[3],
                           palpate_contact* contact)
{
  if (tracker == nullptr || probe == nullptr || contact == nullptr)
  {
    return 0;
  }
  const Vector3 place = VectorOf(probe);
  Contact deepest;
  Vector3 force = Vector3::Zero();
  int id = 0;
  int isValid = 1;
  for (palpate_tracker::Structure& structure : tracker->Structures)
  {
    const Contact& felt = structure.Tracker->Follow({place, Eigen::Quaterniond::Identity()});
    isValid = felt.IsValid ? isValid : 0;
    if (!felt.IsValid || !felt.IsTouching)
    {
      continue;
    }
    force += felt.Elastic != nullptr ? felt.Elastic->ForceWorld
                                     : Vector3(structure.Stiffness * (felt.ProxyWorld - place));
    if (id == 0 || felt.Depth > deepest.Depth)
    {
      deepest = felt;
      id = structure.Id;
    }
  }
  *contact = {};
  contact->id = isValid != 0 ? id : 0;
  Copy(contact->id != 0 ? deepest.ProxyWorld : place, contact->proxy);
  if (contact->id != 0)
  {
    Copy(deepest.NormalWorld, contact->normal);
    contact->depth = deepest.Depth;
    Copy(force, contact->force);
  }
  return isValid;
}

void palpate_tracker_release(palpate_tracker* tracker)
{
  if (tracker == nullptr)
  {
    return;
  }
  for (palpate_tracker::Structure& structure : tracker->Structures)
  {
    structure.Tracker->Release();
  }
}
