#include "StudyJson.h"

#include "JsonText.h"
#include "Refusal.h"
#include "SceneJson.h"
#include "SceneToolJson.h"
#include "SessionUpgrade.h"

namespace palpate
{
namespace
{
using OrderedJson = nlohmann::ordered_json;

constexpr const char* Format = "palpate-study";
constexpr int Version = 2;
constexpr double LargestPlace = 1e6; // mm, of coordinates
constexpr double LargestIntensity = 1e300;

const std::initializer_list<const char*> SliceAxesWords{"patient", "volume"};

OrderedJson Numbers(const Vector3& v)
{
  return {v[0], v[1], v[2]};
}

template <typename T>
void AddIfGiven(OrderedJson& object, const char* key, const std::optional<T>& value)
{
  if (value)
  {
    if constexpr (std::is_same_v<T, Vector3>)
    {
      object[key] = Numbers(*value);
    }
    else
    {
      object[key] = *value;
    }
  }
}

// Calls `read` with a value to fill if the object has the entry.
template <typename T, typename Read>
void ReadIfGiven(JsonFields& fields, const char* key, std::optional<T>& value, const Read& read)
{
  if (fields.Has(key))
  {
    T given{};
    read(given);
    value = given;
  }
}

void ReadIfGiven(JsonFields& fields, const char* key, std::optional<double>& value, double least,
                 double most)
{
  ReadIfGiven(fields, key, value, [&](double& given) { fields.Exchange(key, given, least, most); });
}

void ReadPlace(JsonFields& fields, const char* key, Vector3& place)
{
  fields.Exchange(key, place, -LargestPlace, LargestPlace);
}

// Reads a session's root object.
class StudyReader
{
public:
  StudyReader(const nlohmann::json& root, const std::filesystem::path& folder,
              const std::filesystem::path& file)
      : Root(root), Folder(folder), File(file)
  {
  }

  StudyState Read() const
  {
    StudyState state;
    JsonFields fields(this->Root, this->File, "study");
    this->CheckFormat(fields);
    this->ReadFiles(fields, state);
    if (fields.Has("scene"))
    {
      JsonFields scene(this->Root["scene"], this->File, "scene");
      static_cast<SceneSettings&>(state) =
          ReadSceneJson(this->Root["scene"], scene, this->Folder, this->File);
      scene.RefuseOthers();
    }
    this->ForEach(fields, "landmarks", state.Landmarks, &StudyReader::ReadLandmark);
    this->ForEach(fields, "distances", state.Distances, &StudyReader::ReadDistance);
    this->ReadView(fields, state.View);
    fields.RefuseOthers();
    return state;
  }

private:
  void CheckFormat(JsonFields& fields) const
  {
    std::string format;
    int version = Version;
    fields.Exchange("format", format);
    if (format != Format)
    {
      Refuse(this->File, "is not marked as a Palpate session",
             "begin it with \"format\": \"" + std::string(Format) + "\"");
    }
    fields.Exchange("version", version, 1, 1000);
    if (version > Version)
    {
      Refuse(this->File,
             "is a session of version " + std::to_string(version) + ", newer than this program's " +
                 std::to_string(Version),
             "open it with a newer Palpate");
    }
  }

  std::filesystem::path ReadPath(JsonFields& fields, const char* key) const
  {
    std::string text;
    fields.Exchange(key, text);
    return text.empty() ? std::filesystem::path()
                        : (this->Folder / std::filesystem::u8path(text)).lexically_normal();
  }

  void ReadFiles(JsonFields& fields, StudyState& state) const
  {
    state.VolumeFile = this->ReadPath(fields, "volume");
    fields.Exchange("dicom_series", state.DicomSeries);
    state.SegmentationFile = this->ReadPath(fields, "segmentation");
  }

  // Reads every object of the list `key`.
  template <typename T>
  void ForEach(JsonFields& fields, const std::string& key, std::vector<T>& values,
               T (*read)(JsonFields& fields)) const
  {
    if (!fields.Has(key.c_str()))
    {
      return;
    }
    const nlohmann::json& list = this->Root[key];
    if (!list.is_array())
    {
      Refuse(this->File, "cannot be read: its \"" + key + "\" is not a list",
             "write it as [ { ... }, ... ]");
    }
    for (const nlohmann::json& object : list)
    {
      JsonFields entry(object, this->File, key + "[" + std::to_string(values.size()) + "]");
      values.push_back(read(entry));
      entry.RefuseOthers();
    }
  }

  static StudyLandmark ReadLandmark(JsonFields& fields)
  {
    StudyLandmark landmark;
    fields.Exchange("name", landmark.Name);
    ReadPlace(fields, "position_mm", landmark.PositionWorld);
    return landmark;
  }

  static StudyDistance ReadDistance(JsonFields& fields)
  {
    StudyDistance distance;
    fields.Exchange("name", distance.Name);
    ReadPlace(fields, "from_mm", distance.FromWorld);
    ReadPlace(fields, "to_mm", distance.ToWorld);
    return distance;
  }

  void ReadView(JsonFields& fields, StudyView& view) const
  {
    if (fields.Has("view"))
    {
      JsonFields look(this->Root["view"], this->File, "view");
      ReadIfGiven(look, "crosshair_mm", view.CrosshairWorld,
                  [&](Vector3& place) { ReadPlace(look, "crosshair_mm", place); });
      ReadIfGiven(look, "window", view.Window, 0.0, LargestIntensity);
      ReadIfGiven(look, "level", view.Level, -LargestIntensity, LargestIntensity);
      look.Exchange("layout", view.Layout);
      look.Exchange("overlay_opacity", view.OverlayOpacity, 0.0, 1.0);
      look.Exchange("slice_axes", view.UsesVolumeAxes, SliceAxesWords);
      look.Exchange("slices_follow_probe", view.SlicesFollowProbe);
      look.RefuseOthers();
    }
  }

  const nlohmann::json& Root;
  const std::filesystem::path& Folder;
  const std::filesystem::path& File;
};

OrderedJson AsJson(const StudyLandmark& landmark)
{
  return {{"name", landmark.Name}, {"position_mm", Numbers(landmark.PositionWorld)}};
}

OrderedJson AsJson(const StudyDistance& distance)
{
  return {{"name", distance.Name},
          {"from_mm", Numbers(distance.FromWorld)},
          {"to_mm", Numbers(distance.ToWorld)}};
}

template <typename T>
OrderedJson AsJson(const std::vector<T>& values)
{
  OrderedJson list = OrderedJson::array();
  for (const T& value : values)
  {
    list.push_back(AsJson(value));
  }
  return list;
}

OrderedJson AsJson(const StudyView& view)
{
  OrderedJson object = OrderedJson::object();
  AddIfGiven(object, "crosshair_mm", view.CrosshairWorld);
  AddIfGiven(object, "window", view.Window);
  AddIfGiven(object, "level", view.Level);
  object["layout"] = view.Layout;
  object["overlay_opacity"] = view.OverlayOpacity;
  object["slice_axes"] = WordOf(SliceAxesWords, view.UsesVolumeAxes);
  object["slices_follow_probe"] = view.SlicesFollowProbe;
  return object;
}

void AddPath(OrderedJson& root, const char* key, const std::filesystem::path& path,
             const std::filesystem::path& folder)
{
  if (!path.empty())
  {
    root[key] = RelativeFile(path, folder);
  }
}

OrderedJson AsJson(const StudyState& state, const std::filesystem::path& folder)
{
  OrderedJson root{{"format", Format}, {"version", Version}};
  AddPath(root, "volume", state.VolumeFile, folder);
  if (!state.DicomSeries.empty())
  {
    root["dicom_series"] = state.DicomSeries;
  }
  AddPath(root, "segmentation", state.SegmentationFile, folder);
  root["scene"] = OrderedJson::object();
  AddSceneJson(root["scene"], state, folder);
  root["landmarks"] = AsJson(state.Landmarks);
  root["distances"] = AsJson(state.Distances);
  root["view"] = AsJson(state.View);
  return root;
}
} // namespace

std::string StudyText(const StudyState& state, const std::filesystem::path& folder,
                      const std::filesystem::path& file)
{
  try
  {
    return AsJson(state, folder).dump(2) + "\n";
  }
  catch (const OrderedJson::type_error&)
  {
    Refuse(file, "cannot be written: it contains a name that is not UTF-8",
           "rename the file or the structure");
  }
}

StudyState StudyFromText(const std::string& text, const std::filesystem::path& folder,
                         const std::filesystem::path& file)
{
  nlohmann::json root = ParseJson(text, file, "fix it there, or open another session");
  UpgradeSession(root);
  return StudyReader(root, folder, file).Read();
}
} // namespace palpate
