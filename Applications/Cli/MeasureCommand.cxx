#include "MeasureCommand.h"

#include "Console.h"
#include "DecimalText.h"
#include "FileFormat.h"
#include "FileType.h"
#include "InputError.h"
#include "Interruption.h"
#include "JsonNumbers.h"
#include "JsonSchema.h"
#include "ModelFile.h"
#include "StructurePairs.h"
#include "SurfaceFile.h"
#include "TextTable.h"
#include "VectorText.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <ostream>

namespace palpate::cli
{
namespace
{
constexpr double Far = 2.0; // mm: a point that is farther from the surface is mentioned

Vector3 PlaceOf(const std::string& option, const std::string& word)
{
  const Vector3 place = ParseVector(option, word);
  if (place.cwiseAbs().maxCoeff() > FarthestCompared)
  {
    throw InputError(option + " " + word + " is farther than 10 km from the origin; give it in mm");
  }
  return place;
}

void Note(const Vector3& given, const Vector3& found, const std::string& word, Console& console)
{
  if (const double distance = (given - found).norm(); distance > Far)
  {
    console.Note(word + " lies " + FixedText(distance, 1) +
                 " mm from the surface; measured from the nearest point of it");
  }
}

std::string TextOf(const std::vector<BodyGeodesics::Length>& lengths,
                   const std::vector<std::string>& words)
{
  TextTable table;
  for (std::size_t n = 0; n < lengths.size(); ++n)
  {
    table.AddRow({"to " + words[n], FixedText(lengths[n].Along, 3) + " mm along the surface",
                  FixedText(lengths[n].Direct, 3) + " mm straight"});
  }
  return table.Text();
}
} // namespace

std::string MeasureCommand::Examples() const
{
  return "  palpate measure model.json --from 20,0,5 --to -18,3,0     a model, on itself\n"
         "  palpate measure mask.nii.gz --label 1 --from 20,0,5 --to -18,3,0 --path path.vtp\n"
         "  palpate measure surface.stl --from 20,0,5 --map map.vtp   to every point\n"
         "  palpate render map.vtp --array DistanceAlongSurface --output map.png";
}

void MeasureCommand::DeclareOptions(CLI::App& app)
{
  app.add_option("FILE", this->Input,
                 "Segmentation, surface (" + ListOfEndings(SurfaceFormats().ReadEndings()) +
                     ") or model (" + ListOfEndings(ReadableModelEndings()) + ")")
      ->required()
      ->check(FileType::Input("file"));
  app.add_option("--label", this->Label, "Structure of a segmentation")->type_name("N|NAME");
  app.add_option("--from", this->From, "Where to measure from: mm, patient LPS")
      ->type_name("X,Y,Z")
      ->required();
  app.add_option("--to", this->To, "Where to measure to; may be repeated")
      ->type_name("X,Y,Z")
      ->allow_extra_args(false);
  this->Images.Declare(app, "folder");
  this->Images.DeclareValues(app);
  app.add_option("--path", this->Path, "Lines to write: the shortest paths (.vtp)")
      ->type_name("FILE")
      ->check(FileType::Output("geometry", ".vtp"));
  app.add_option("--map", this->Map,
                 "Surface to write, with the distance of each of its points (.vtp)")
      ->type_name("FILE")
      ->check(FileType::Output("geometry", ".vtp"));
  app.add_flag("--json", this->Json, "Print one JSON object");
}

std::string MeasureCommand::JsonOf(const BodyGeodesics& body,
                                   const std::vector<BodyGeodesics::Length>& lengths) const
{
  using JsonObject = nlohmann::ordered_json;
  JsonObject list = JsonObject::array();
  for (const BodyGeodesics::Length& length : lengths)
  {
    JsonObject uncertainty;
    if (length.Uncertainty)
    {
      uncertainty = *length.Uncertainty;
    }
    list.push_back({{"from_mm", PointJson(length.From)},
                    {"to_mm", PointJson(length.To)},
                    {"along_mm", length.Along},
                    {"straight_mm", length.Direct},
                    {"uncertainty_mm", uncertainty}});
  }
  const auto nameOf = [](const std::filesystem::path& file)
  { return file.empty() ? JsonObject() : JsonObject(file.string()); };
  const JsonObject result{{JsonSchemaKey, JsonSchemaVersion},
                          {"input", this->Input.string()},
                          {"on", body.IsOnModel() ? "model" : "triangles"},
                          {"distances", list},
                          {"path", nameOf(this->Path)},
                          {"map", nameOf(this->Map)}};
  return result.dump(-1, ' ', false, JsonObject::error_handler_t::replace) + "\n";
}

int MeasureCommand::Run(Console& console)
{
  const Interruption interruption;
  if (this->To.empty() && (this->Map.empty() || !this->Path.empty()))
  {
    throw InputError("there is nothing to measure to; give --to, or --map for the whole surface");
  }
  const ProgressFunction progress = [&](double fraction, const std::string& stage)
  {
    console.Progress(fraction, stage);
    return !Interruption::WasAsked();
  };
  const Vector3 from = PlaceOf("--from", this->From);
  const ComparedFile file = ComparedFile::Read(this->Input, this->Images.Choice());
  const BodyGeodesics body(file, OnlyStructure(file, this->Label, "choose one by --label"));
  std::vector<BodyGeodesics::Length> lengths;
  for (const std::string& word : this->To)
  {
    const Vector3 to = PlaceOf("--to", word);
    lengths.push_back(body.Find(from, to, progress));
    Note(to, lengths.back().To, "--to " + word, console);
  }
  if (!lengths.empty())
  {
    Note(from, lengths.front().From, "--from " + this->From, console);
  }
  if (!this->Path.empty())
  {
    WriteLines(this->Path, LinesOf(lengths));
  }
  if (!this->Map.empty())
  {
    WriteSurface(this->Map, body.Map(from, progress));
  }
  console.EndProgress();
  console.Output() << (this->Json ? this->JsonOf(body, lengths) : TextOf(lengths, this->To));
  return 0;
}
} // namespace palpate::cli
