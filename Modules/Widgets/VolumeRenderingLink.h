#pragma once

#include "RenderedVolume.h"
#include "SpacePane.h"
#include "StudyController.h"
#include "ViewContents.h"

#include <QObject>

#include <map>
#include <memory>
#include <optional>

namespace palpate
{
/// Draws the volumes of the study that are to be seen in 3-D. Each is prepared by a job of the
/// study; the view draws it once that is done.
class VolumeRenderingLink : public QObject
{
  Q_OBJECT

public:
  /// Keeps the addresses.
  VolumeRenderingLink(StudyController& study, const ViewContents& contents, SpacePane& space,
                      QObject* parent);
  ~VolumeRenderingLink() override;

  /// Whether a volume is being prepared.
  bool IsBusy() const;

private:
  struct Drawn
  {
    std::shared_ptr<const Volume> Source;
    std::shared_ptr<RenderedVolume> Made; // null until it is prepared
    StudyJobs::Id Job = 0;
  };

  void FollowStudy();
  void Follow(int id);
  void Drop(std::map<int, Drawn>::iterator one);
  void Prepare(int id, Drawn& drawn);
  void ShowWindows();
  void ShowProps();
  void FitRays();
  bool UsesCard();

  StudyController& Study;
  const ViewContents& Contents;
  SpacePane& Space;
  std::map<int, Drawn> Volumes; // by id; 0: the first volume
  std::optional<bool> HasCard;  // once asked
};
} // namespace palpate
