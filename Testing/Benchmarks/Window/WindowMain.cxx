// PalpateWindow FILE [SECONDS]: measures the servo next to what the window does, how long the
// window takes to start and to close, and what volumes and structures cost, and writes them as
// JSON; see Utilities/window.sh. `PalpateWindow --start` is what it starts.
#include "Application.h"
#include "DisplayCheck.h"
#include "MachineName.h"
#include "WindowFigures.h"
#include "WindowMeasures.h"

#include <QSurfaceFormat>

#include <algorithm>
#include <exception>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace
{
using palpate::bench::WindowClosing;
using palpate::bench::WindowStretch;

nlohmann::json ToJson(const palpate::PeriodStatistics& statistics)
{
  constexpr double Microseconds = 1e-3; // of a nanosecond
  const auto at = [&](double fraction)
  { return Microseconds * static_cast<double>(statistics.Quantile(fraction)); };
  return {{"median", at(0.5)},
          {"p99", at(0.99)},
          {"p999", at(0.999)},
          {"largest", Microseconds * static_cast<double>(statistics.Max())}};
}

nlohmann::json ToJson(const WindowStretch& stretch)
{
  return {{"name", stretch.Name},
          {"seconds", stretch.Seconds},
          {"ticks", stretch.Ticks},
          {"touching", stretch.Touching},
          {"missed", stretch.Missed},
          {"faults", stretch.Faults},
          {"pictures", stretch.Images},
          {"events", stretch.Events},
          {"period", ToJson(stretch.Periods)},
          {"tick", ToJson(stretch.Durations)}};
}

nlohmann::json Figures(const char* program)
{
  const auto memory = palpate::bench::MeasureVolumeMemory(); // first: nothing was freed before
  const auto structures = palpate::bench::MeasureStructures();
  const auto start = palpate::bench::MeasureStart(program);
  return {{"memory", {{"volumes", memory.VolumeBytes}, {"growth", memory.GrowthBytes}}},
          {"structures",
           {{"list", structures.List},
            {"search", structures.Search},
            {"show_all", structures.ShowAll},
            {"show_none", structures.ShowNone},
            {"opened", structures.Opened},
            {"modelled", structures.Modelled}}},
          {"start", {{"window", start.Window}, {"head", start.Head}}}};
}

void Measure(const char* program, const char* file, double seconds)
{
  nlohmann::json all{{"machine", palpate::MachineName()}};
  all["figures"] = Figures(program);
  palpate::bench::WindowMeasures measures(seconds);
  for (const WindowStretch& stretch : measures.Blending())
  {
    const int fewest = *std::min_element(stretch.Images.begin(), stretch.Images.end());
    all["blending"].push_back(
        {{"name", stretch.Name},
         {"frames", fewest / stretch.Seconds},
         {"touching", static_cast<double>(stretch.Touching) / static_cast<double>(stretch.Ticks)}});
  }
  for (const WindowStretch& stretch : measures.Stretches())
  {
    all["stretches"].push_back(ToJson(stretch));
  }
  for (const WindowClosing& closing : palpate::bench::WindowMeasures::Closings())
  {
    all["closings"].push_back({{"while", closing.While},
                               {"milliseconds", closing.Milliseconds},
                               {"ended", closing.HasEnded}});
  }
  std::ofstream out(file);
  out << all.dump(1) << '\n';
  if (!out.good())
  {
    throw std::runtime_error(std::string(file) + " cannot be written");
  }
}
} // namespace

int main(int argc, char** argv)
{
  if (argc < 2)
  {
    std::cerr << "usage: PalpateWindow FILE.json [SECONDS]\n";
    return 2;
  }
  try
  {
    palpate::RequireDisplay();
    QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
    const palpate::Application application(argc, argv);
    QApplication::setApplicationName("PalpateWindow");
    QApplication::setQuitOnLastWindowClosed(false);
    if (std::string(argv[1]) == "--start")
    {
      palpate::bench::DrawFirstPictures();
      return 0;
    }
    Measure(argv[0], argv[1], argc > 2 ? std::stod(argv[2]) : 20.0);
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
