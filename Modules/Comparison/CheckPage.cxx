#include "CheckPage.h"

#include "CheckText.h"
#include "DecimalText.h"
#include "HtmlText.h"
#include "MaskSurface.h"
#include "RasterImage.h"
#include "ReportPage.h"
#include "ReportTable.h"
#include "SixViews.h"
#include "SoftwareRenderer.h"
#include "TriangleMesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace palpate
{
namespace
{
constexpr std::size_t MostPictures = 24;
constexpr std::size_t MostCheckRows = 2000;
constexpr SoftwareRenderer::Color Tissue{{205, 190, 172}};
constexpr SoftwareRenderer::Color Mark{{220, 38, 38}};

// Points of the surface near the place are marked: within a tenth of the body's size of it, or of
// what is next to it of the surface, for a place inside.
std::vector<SoftwareRenderer::Color> MarkedColors(const IndexedMesh& mesh, const Vector3& place)
{
  Eigen::AlignedBox3d box;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Vector3& point : mesh.Points)
  {
    box.extend(point);
    nearest = std::min(nearest, (point - place).norm());
  }
  const double reach = nearest + 0.06 * box.diagonal().norm();
  std::vector<SoftwareRenderer::Color> colors(mesh.Points.size(), Tissue);
  for (std::size_t n = 0; n < colors.size(); ++n)
  {
    if ((mesh.Points[n] - place).norm() <= reach)
    {
      colors[n] = Mark;
    }
  }
  return colors;
}

// The slice of a mask through the place, along the axis of the largest spacing, with a ring there.
ReportFigure SliceWithRing(const CheckedMask& given, const Vector3& place)
{
  const CheckedMask mask = WithSlicesLast(given);
  const VoxelMask& voxels = mask.Voxels;
  const Vector3 index = mask.ToWorld.Axes.inverse() * (place - mask.ToWorld.Origin) -
                        Vector3(voxels.StartIndex[0], voxels.StartIndex[1], voxels.StartIndex[2]);
  const int k = std::clamp(static_cast<int>(std::lround(index[2])), 0, voxels.Size[2] - 1);
  RasterImage raster(voxels.Size[0], voxels.Size[1]);
  for (int j = 0; j < voxels.Size[1]; ++j)
  {
    for (int i = 0; i < voxels.Size[0]; ++i)
    {
      const bool isInside = voxels.Inside[voxels.Offset(i, j, k)] != 0;
      std::uint8_t* const pixel = raster.Pixel(i, j);
      for (std::size_t c = 0; c < 3; ++c)
      {
        pixel[c] = isInside ? Tissue[c] : 24;
      }
      pixel[3] = 255;
    }
  }
  const double width = voxels.Size[0] * voxels.Spacing[0];
  const double height = voxels.Size[1] * voxels.Spacing[1];
  const std::string size =
      " width=\"" + FixedText(width, 2) + "\" height=\"" + FixedText(height, 2) + "\"";
  const double x = (std::clamp(index[0], 0.0, voxels.Size[0] - 1.0) + 0.5) * voxels.Spacing[0];
  const double y = (std::clamp(index[1], 0.0, voxels.Size[1] - 1.0) + 0.5) * voxels.Spacing[1];
  ReportFigure figure;
  figure.Svg = "<svg viewBox=\"0 0 " + FixedText(width, 2) + " " + FixedText(height, 2) +
               "\" role=\"img\" aria-label=\"slice\"><image preserveAspectRatio=\"none\"" + size +
               " style=\"image-rendering:pixelated\" href=\"" + PngDataUri(raster) +
               "\"/><circle fill=\"none\" stroke=\"#dc2626\" stroke-width=\"" +
               FixedText(0.012 * (width + height), 3) + "\" cx=\"" + FixedText(x, 2) + "\" cy=\"" +
               FixedText(y, 2) + "\" r=\"" + FixedText(0.06 * (width + height), 2) + "\"/></svg>";
  figure.Caption = "The slice through the place";
  return figure;
}

void AddPictures(ReportPage& page, const CaseCheck& check, std::size_t organ,
                 const CheckedMask& mask)
{
  const OrganJudgement& judgement = check.Judgements[organ];
  const std::string& name = check.Patient.Organs[organ].Name;
  page.Section(check.Name + ": " + name)
      .Verdict(VerdictStyle(judgement.Is), VerdictWord(judgement.Is),
               name + " " + JudgementSentence(judgement) + ", at " +
                   PatientPlace(judgement.Reason.Place) + " mm.");
  page.Figure("views", SliceWithRing(mask, judgement.Reason.Place));
  IndexedMesh mesh;
  if (MakeMaskBoundary(mask.Voxels, mask.ToWorld, mesh).IsOk())
  {
    TriangleMesh triangles;
    triangles.PointsWorld = mesh.Points;
    triangles.Triangles = mesh.Triangles;
    SoftwareRenderer renderer(PolyDataOf(triangles));
    renderer.SetPointColors(MarkedColors(mesh, judgement.Reason.Place));
    AddSixViews(page, renderer);
  }
}

ReportTable RowsOf(const MaskChecks& checks)
{
  ReportTable table(
      {"Case", "Structure", "Verdict", "It", "At, mm", "p of a clean case", "Volume, ml"}, true);
  std::size_t rows = 0;
  for (const CaseCheck& one : checks.Cases)
  {
    for (std::size_t n = 0; n < one.Judgements.size() && rows < MostCheckRows; ++n, ++rows)
    {
      const OrganJudgement& judgement = one.Judgements[n];
      const bool isPlausible = judgement.Is == OrganJudgement::Verdict::Plausible;
      table.Text(one.Name)
          .Text(one.Patient.Organs[n].Name)
          .Marked(VerdictStyle(judgement.Is), VerdictWord(judgement.Is))
          .Text(JudgementSentence(judgement))
          .Text(isPlausible ? std::string() : PatientPlace(judgement.Reason.Place))
          .Number(judgement.IsByGroup ? judgement.Probability
                                      : std::numeric_limits<double>::quiet_NaN(),
                  3)
          .Number(one.Patient.Organs[n].Measured.Milliliters, 2);
    }
  }
  return table;
}
} // namespace

std::string CheckPage(const MaskChecks& checks)
{
  std::vector<std::string> notes = checks.Notes;
  std::vector<std::string> unchecked;
  for (const CaseCheck& one : checks.Cases)
  {
    for (const std::string& note : one.Notes)
    {
      notes.push_back(one.Name + ": " + note);
    }
    for (const RefusedMask& mask : one.Refused)
    {
      unchecked.push_back(one.Name + ": " + mask.Message);
    }
    if (!one.IsChecked())
    {
      unchecked.push_back(one.Name + ": " + one.Message);
    }
  }
  ReportPage page;
  page.Header("believable or not", CheckTally(checks), "Judged " + CheckBasis(checks) + ".")
      .Section("Notes")
      .Notes(notes)
      .Section("Not checked")
      .Notes(unchecked)
      .Section("Structures")
      .Table(RowsOf(checks));
  std::size_t pictures = 0;
  for (const CaseCheck& one : checks.Cases)
  {
    for (const auto& [organ, mask] : one.Doubtful)
    {
      if (pictures++ < MostPictures)
      {
        AddPictures(page, one, organ, mask);
      }
    }
  }
  return page.Whole("Believable or not", "Places are millimetres in the patient’s frame. For "
                                         "research; not a medical device.");
}
} // namespace palpate
