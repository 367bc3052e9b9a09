#include "EvaluateCommand.h"

#include "Console.h"
#include "EvaluationText.h"
#include "FileFormat.h"
#include "FileType.h"
#include "IcosahedronDirections.h"
#include "InputError.h"
#include "ModelFile.h"
#include "VectorText.h"

#include <CLI/CLI.hpp>
#include <ostream>

namespace palpate::cli
{
namespace
{
constexpr double FarthestPoint = 1e12; // mm; squares of distances are far from overflow

Vector3 UnitVector(const std::string& subject, const std::string& word)
{
  const Vector3 vector = ParseVector(subject, word);
  // Scaled first, so that lengths of extreme numbers neither overflow nor vanish.
  const double largest = vector.cwiseAbs().maxCoeff();
  if (!(largest > 0.0))
  {
    throw InputError(subject + " " + word + " is not a direction; give x,y,z that are not all 0.");
  }
  return (vector / largest).normalized();
}
} // namespace

std::string EvaluateCommand::Examples() const
{
  return "  palpate evaluate model.json                          volume, area, spectrum\n"
         "  palpate evaluate model.json --direction 1,0,0 --direction 0,0,1\n"
         "  palpate evaluate model.json --point 10,-5,22.5       inside or outside, and the "
         "distance\n"
         "  palpate evaluate model.json --frequency 20 --json > samples.json   4,002 directions";
}

void EvaluateCommand::DeclareOptions(CLI::App& app)
{
  app.add_option("MODEL", this->Model, "Model: " + ListOfEndings(ReadableModelEndings()))
      ->required()
      ->check(FileType::Input("file"));
  app.add_option("--direction", this->DirectionWords,
                 "Evaluate along this direction from the centre (LPS), of a surface model at this "
                 "parameter; may be repeated")
      ->type_name("X,Y,Z")
      ->allow_extra_args(false);
  app.add_option("--frequency", this->Frequency,
                 "Evaluate along the 10 F^2 + 2 directions of a subdivided icosahedron")
      ->type_name("F")
      ->check(CLI::Range(1, 200));
  app.add_option("--point", this->PointWords,
                 "Report whether this point (mm, LPS) is inside, and its distance; may be repeated")
      ->type_name("X,Y,Z")
      ->allow_extra_args(false);
  app.add_flag("--json", this->Json, "Print one JSON object");
}

std::vector<Vector3> EvaluateCommand::UnitDirections() const
{
  std::vector<Vector3> directions;
  for (const std::string& word : this->DirectionWords)
  {
    directions.push_back(UnitVector("--direction", word));
  }
  if (this->Frequency > 0)
  {
    const IcosahedronDirections sphere(this->Frequency);
    directions.insert(directions.end(), sphere.Directions().begin(), sphere.Directions().end());
  }
  return directions;
}

int EvaluateCommand::Run(Console& console)
{
  const std::vector<Vector3> directions = this->UnitDirections();
  std::vector<Vector3> pointsWorld;
  for (const std::string& word : this->PointWords)
  {
    pointsWorld.push_back(ParseVector("--point", word));
    if (pointsWorld.back().cwiseAbs().maxCoeff() > FarthestPoint)
    {
      throw InputError("--point " + word +
                       " is farther than a million km from the origin; give it in mm");
    }
  }
  const ModelEvaluation evaluation =
      EvaluateModel(this->Model, ReadModel(this->Model).Surface, directions, pointsWorld);
  console.Output() << (this->Json ? EvaluationAsJson(evaluation) : EvaluationAsText(evaluation));
  return 0;
}
} // namespace palpate::cli
