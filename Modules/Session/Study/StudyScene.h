#pragma once

#include "DeviceCapabilities.h"
#include "PalpateSessionModule.h"
#include "StudyPipeline.h"
#include "StudyState.h"
#include "TouchScene.h"

#include <memory>
#include <vector>

namespace palpate
{
/// A structure of a study that can be touched now.
struct StudyContact
{
  int Label = 0;
  std::shared_ptr<const TouchContact> Contact;
};

/// Those of the state's touchable structures whose newest model is there.
PALPATESESSION_EXPORT std::vector<StudyContact> ContactsOf(const StudyState& state,
                                                           const StudyPipeline& pipeline);

/// Where the device's frame lies: world = center + scale * rotation * device.
struct StudyFrame
{
  Matrix3 Rotation = Matrix3::Identity();
  double Scale = 1.0;
  Vector3 CenterWorld = Vector3::Zero(); ///< mm

  Vector3 ToDevice(const Vector3& pointWorld) const
  {
    return this->Rotation.transpose() * (pointWorld - this->CenterWorld) / this->Scale;
  }
  friend bool operator==(const StudyFrame& a, const StudyFrame& b)
  {
    return a.Rotation == b.Rotation && a.Scale == b.Scale && a.CenterWorld == b.CenterWorld;
  }
};

/// Those of `contacts` whose structures the state has and wants touchable.
PALPATESESSION_EXPORT std::vector<StudyContact>
TouchableOf(const StudyState& state, const std::vector<StudyContact>& contacts);

/// What a hand is to feel: a structure for each of `contacts`, which are touchable. Throws
/// InputError for a tool that is none.
PALPATESESSION_EXPORT TouchScene MakeStudyScene(const StudyState& state,
                                                const std::vector<StudyContact>& contacts,
                                                const StudyFrame& frame);

/// A frame in the patient's axes in which all of a scene is in reach.
PALPATESESSION_EXPORT StudyFrame ReachingFrame(const TouchScene& scene,
                                               const DeviceCapabilities& device);
} // namespace palpate
