#include "DrillBenchmarks.h"

#include "DrillEditor.h"
#include "FieldBuilder.h"
#include "FieldContactModel.h"
#include "Servo.h"
#include "TouchDoubles.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>
#include <string>

namespace palpate::bench
{
namespace
{
constexpr double DrilledSpacing = 0.3; // mm
constexpr int Size = 120;              // nodes along an axis
constexpr double Top = 12.0;           // mm
constexpr std::size_t DrillTicks = 400;

FieldGrid Grid()
{
  return {{Size, Size, Size},
          Vector3::Constant(-0.5 * DrilledSpacing * (Size - 1)),
          Vector3::Constant(DrilledSpacing),
          Matrix3::Identity()};
}

std::shared_ptr<const ScalarField> Build(const std::vector<float>& samples)
{
  const FieldGrid grid = Grid();
  FieldBuilder builder(grid);
  builder.KeepInside(
      builder.AddMaterial({builder.AddChannel(SamplesOfGrid(samples.data(), grid)), 500.0}));
  std::shared_ptr<const ScalarField> field;
  return builder.Build(field).IsOk() ? field : nullptr;
}

std::vector<float> Block()
{
  const FieldGrid grid = Grid();
  std::vector<float> samples;
  for (int n = 0; n < Size * Size * Size; ++n)
  {
    const Vector3 index(n % Size, n / Size % Size, n / (Size * Size));
    const double depth = (Top - grid.PointWorld(index)[2]) / DrilledSpacing;
    samples.push_back(static_cast<float>(1000.0 * std::clamp(0.5 + 0.5 * depth, 0.0, 1.0)));
  }
  return samples;
}

// A hand that presses a spherical drill into a block of bone and moves in circles; single-threaded,
// at full speed.
class DrillCase
{
public:
  explicit DrillCase(double radius) : Radius(radius), Samples(Block()), Field(Build(this->Samples))
  {
    std::vector<std::unique_ptr<DrilledField>> fields(1);
    std::shared_ptr<const ContactModel> model;
    int tool = 0;
    this->IsMade = DrilledField::Make(*this->Field, 0, fields[0]).IsOk() &&
                   DrillEditor::Make(std::move(fields), this->Editor).IsOk() &&
                   this->Editor->AddTool(CutTool::Sphere(radius), tool).IsOk() &&
                   FieldContactModel::Make(this->Field, 0, model).IsOk();
    this->Scene.Tool = ToolShape::Sphere(radius - 0.1 * DrilledSpacing);
    this->Scene.Structures.push_back({"bone", model, {1.0, 0.0}, {}});
    this->Scene.Structures[0].Site = 0;
    this->Scene.Structures[0].Drill = {0.5, 0.002, 0.2};
    this->Scene.Drill.Link = this->Editor->Link();
    this->Scene.Drill.Motion = {radius, 1000.0};
    this->Scene.Drill.Clearance = 0.1 * DrilledSpacing;
  }

  // Starts with undrilled bone, which it restores at the end.
  void Drill()
  {
    if (!this->IsMade)
    {
      return;
    }
    test::ScriptedDevice device;
    Servo servo(device, {});
    this->Editor->ForNextServo();
    static_cast<void>(servo.Publish(std::make_shared<const TouchScene>(this->Scene)));
    servo.RunDrill(true);
    this->Press(device, servo);
    this->Orders = servo.Latest().DrillOrders;
    this->Newest = this->Editor->Newest().Fields[0];
    if (this->After.empty()) // the same every time
    {
      this->Removed = this->Editor->RemovedVolumes()[0];
      this->After.resize(this->Samples.size());
      this->Editor->WriteSamples(0, SamplesOfGrid(this->Samples.data(), Grid()),
                                 this->After.data());
      this->SurfaceCells = this->Newest->SurfaceCells().size();
    }
    servo.Command(DrillCommand::Reset);
    TickInfo last;
    last.Number = DrillTicks;
    servo.Tick(last);
    this->Editor->Take();
  }

  // The same hand on bone that is not removed.
  void Touch()
  {
    test::ScriptedDevice device;
    Servo servo(device, {});
    static_cast<void>(servo.Publish(std::make_shared<const TouchScene>(this->Scene)));
    this->Press(device, servo);
  }

  // Rebuilds the drilled field from its samples.
  void BuildFromSamples() { this->FadeIn = Build(this->After); }

  std::string Compared()
  {
    this->BuildFromSamples();
    std::ostringstream text;
    if (this->Orders < DrillTicks / 8 || !(this->Removed > 0.5))
    {
      text << "only " << this->Orders << " cuts removed " << this->Removed << " mm3";
    }
    else if (this->SurfaceCells != this->FadeIn->SurfaceCells().size())
    {
      text << "the drilled field has " << this->SurfaceCells
           << " cells with a surface, and one that is built again "
           << this->FadeIn->SurfaceCells().size();
    }
    return text.str();
  }

private:
  void Press(test::ScriptedDevice& device, Servo& servo) const
  {
    for (std::size_t n = 0; n < DrillTicks; ++n)
    {
      const double angle = 0.01 * static_cast<double>(n);
      const double height = Top + this->Radius - std::min(0.02 * static_cast<double>(n), 2.0) + 0.3;
      device.Next.Position = Vector3(3.0 * std::cos(angle), 3.0 * std::sin(angle), height);
      device.Next.Time = static_cast<std::int64_t>(n) * 1'000'000;
      TickInfo tick;
      tick.Number = n;
      tick.Scheduled = device.Next.Time;
      tick.Started = device.Next.Time;
      servo.Tick(tick);
      this->Editor->Take();
    }
  }

  double Radius;
  std::vector<float> Samples;
  std::shared_ptr<const ScalarField> Field;
  std::unique_ptr<DrillEditor> Editor;
  TouchScene Scene;
  bool IsMade = false;
  std::size_t SurfaceCells = 0;
  std::vector<float> After;
  std::shared_ptr<const ScalarField> Newest;
  std::shared_ptr<const ScalarField> FadeIn;
  double Removed = 0.0;
  std::uint64_t Orders = 0;
};

PairedBenchmark DrillBenchmark(double radius, const std::string& name)
{
  const auto drill = std::make_shared<DrillCase>(radius);
  return {"drill/tick/" + name,
          "the same touch without drilling (ours)",
          [drill] { drill->Drill(); },
          [drill] { drill->Touch(); },
          [drill] { return drill->Compared(); },
          DrillTicks};
}
} // namespace

std::vector<PairedBenchmark> DrillBenchmarks()
{
  return {DrillBenchmark(1.5, "1.5mm"), DrillBenchmark(3.0, "3mm")};
}
} // namespace palpate::bench
