#include "StudyMatch.h"

#include "InputError.h"
#include "Refusal.h"
#include "TransformFile.h"

namespace palpate
{
namespace
{
// The transform as it is read again for a file.
void RequireSame(const Eigen::Affine3d& map, const SceneMove& move,
                 const std::filesystem::path& moving)
{
  constexpr double Rounding = 1e-4; // mm, of text
  if (!ReadMove(move, moving).isApprox(map, Rounding))
  {
    Refuse(move.File,
           "is a matrix of FLIRT, which means another transform for " + moving.filename().string(),
           "name it .tfm, .lta or .xfm");
  }
}
} // namespace

StudyState WriteMatch(const StudyState& state, const MatchChoice& choice,
                      const Eigen::Affine3d& map, const std::filesystem::path& file)
{
  const SceneStructure* moving = FindStructure(state, choice.MovingId);
  const SceneStructure* fixed = FindStructure(state, choice.FixedId);
  const StudyVolume* volume = FindVolume(state, choice.VolumeId);
  if (moving == nullptr || fixed == nullptr)
  {
    throw InputError("one of the two structures is not there any more; choose again");
  }
  const SceneMove before = moving->Move;
  if (volume != nullptr && volume->Transform != before.File)
  {
    Refuse(volume->File, "is not moved by the same transform as " + TitleOf(*moving),
           "clear or choose its transform first");
  }
  Eigen::Affine3d total = map;
  if (before.IsSet())
  {
    total = map * ReadMove(before, moving->File);
  }
  const std::filesystem::path source = volume != nullptr ? volume->File : moving->File;
  WriteTransform(file, total, {source, state.VolumeFile});
  const SceneMove after{StudyPath(file), state.VolumeFile};
  RequireSame(total, after, moving->File);
  StudyState next = volume != nullptr ? WithTransform(state, choice.VolumeId, after.File) : state;
  for (SceneStructure& structure : next.Structures)
  {
    const bool goesAlong = structure.Id == choice.MovingId ||
                           (structure.File == moving->File && structure.File != fixed->File &&
                            structure.Move == before);
    structure.Move = goesAlong ? after : structure.Move;
  }
  return next;
}
} // namespace palpate
