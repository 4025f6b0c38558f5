#include "io/import_poses.h"

#include <algorithm>
#include <set>
#include <utility>

#include "io/base/byte_text.h"
#include "io/base/objects.h"
#include "io/import_hints.h"
#include "io/join_keys.h"

namespace shapespline {

namespace {

// Adds a hint to an error: a mismatched pose may just have other objects or another order.
Status hintAtObjects(Status added, const std::vector<std::string>& objects, const std::vector<std::string>& first) {
  if (added || objects == first || objects.size() + first.size() < 3) return added;
  Error error = added.error();
  error.message += " Its objects are " + objectList(objects) + ". The objects of key 1 are " + objectList(first) +
                   ". Leave out objects that are not in every file (on the command line, --object NAME selects one).";
  return error;
}

// The first file's objects that all files share, if some file lacks one; otherwise nothing.
std::vector<std::string> commonObjects(const std::vector<MeshFile>& meshes, std::size_t from, PoseReader reader,
                                       const Import& import) {
  const ObjectMesh first{import.scene.objects, import.keyframes.faces, import.keyframes.keys[0].positions};
  if (!first.isWhole()) return {};
  std::vector<char> inAll(first.objects.size(), 1);
  for (std::size_t j = from; j < meshes.size(); ++j) {
    const auto pose = reader.read(meshes[j], placeName(*meshes[j].file, static_cast<int>(j), meshes.size()));
    if (!pose) return {};
    const ObjectMesh other{pose->scene.objects, pose->faces, pose->positions};
    if (!other.isWhole()) return {};
    const ObjectMatch same = matchObjects(first, other);
    // Without equal names, objects could be matched by shape only.
    const auto has = [&](std::size_t i) {
      const bool unnamed = first.objects[i].nodeName.empty() && first.objects[i].meshName.empty();
      return same.otherOf[i] >= 0 && (same.rule[i] == MatchRule::Name || unnamed);
    };
    for (std::size_t i = 0; i < inAll.size(); ++i) inAll[i] = inAll[i] && has(i);
  }
  std::vector<std::string> common;
  for (std::size_t i = 0; i < inAll.size(); ++i)
    if (inAll[i]) addObject(first.objects[i].name, common);
  return common.size() < import.objects.size() ? common : std::vector<std::string>();
}

// Names keys after the actions that pose their files, if these names differ.
void nameByActions(const std::vector<std::string>& actions, std::vector<Key>& keys) {
  const std::set<std::string> names(actions.begin(), actions.end());
  if (names.size() < keys.size() || names.contains("")) return;
  for (std::size_t k = 0; k < keys.size(); ++k) keys[k].name = actions[k];
}

// Adds the key of a file that hides meshes of key 1.
Status addHidden(PoseFile&& pose, const NamedBytes& file, Import& out, const std::string& where) {
  const auto said = static_cast<std::ptrdiff_t>(out.warnings.size());
  if (Status added = addPose(std::move(pose), keyName(file), out, where); !added) return added;
  const auto isExtra = [](const Warning& warning) { return warning.code == "left-out-objects"; };
  out.warnings.erase(std::remove_if(out.warnings.begin() + said, out.warnings.end(), isExtra), out.warnings.end());
  out.warnings.push_back({"visibility-changes",
                          "(" + placeName(file, 0, 1) +
                              ") has other visible meshes than the first pose (KHR_node_visibility). The meshes "
                              "of the first pose are shown.",
                          1,
                          out.keyframes.keyCount() - 1,
                          -1,
                          {},
                          "Key"});
  return {};
}

int samePoses(const Import& import) {
  int count = 0;
  for (const Warning& warning : import.warnings)
    if (warning.code == "same-poses") count += warning.count;
  return count;
}

// `common`: receives the shared objects if files with different meshes have different objects.
Result<Import> readPoses(const std::vector<MeshFile>& meshes, const SourceFiles& files, const ImportOptions& options,
                         const StageProgress& progress, std::vector<std::string>& common, FileFacts& facts) {
  Import out;
  ImportOptions unfiltered = options;
  unfiltered.objects.clear();
  PoseReader reader{files, options}, everything{files, unfiltered};
  std::vector<std::string> actions, places;
  facts = {static_cast<int>(meshes.size()), 0, 0, 0, areAll(meshes, FileKind::Gltf), false};
  std::vector<AnimationInfo> animations;
  bool writtenZUp = false;
  for (std::size_t j = 0; j < meshes.size(); ++j) {
    const int key = static_cast<int>(j);
    const std::string where = placeName(*meshes[j].file, key, meshes.size());
    const auto onPose = [&](double fraction) {
      if (progress)
        progress("reading the poses", (static_cast<double>(j) + fraction) / static_cast<double>(meshes.size()));
    };
    onPose(0);
    auto pose = reader.read(meshes[j], where, onPose);
    // The objects may have other names in this file. They are then matched by shape.
    if (!pose && j > 0 && pose.error().code == ErrorCode::UnknownObject) {
      everything.cuts = reader.cuts;
      pose = everything.read(meshes[j], where, onPose);
    }
    if (!pose) return atKey(pose.error(), key);
    facts.skinned += pose->skinned;
    facts.isPosed |= pose->isPosed;
    const bool moves = std::any_of(pose->animations.begin(), pose->animations.end(), [](auto& a) { return a.moves; });
    facts.animated += moves;
    facts.posed += !moves && !pose->animations.empty();
    if (j == 0) animations = std::move(pose->animations);
    if (j == 0) writtenZUp = pose->writtenZUp;
    actions.push_back(pose->action);
    places.push_back(placeName(*meshes[j].file, 0, 1));
    const bool hides = pose->hides;
    Status added = addPose(std::move(*pose), keyName(*meshes[j].file), out, where);
    if (!added && hides) {
      ImportOptions hidden = options;
      hidden.withHidden = true;
      auto whole = PoseReader{files, hidden}.read(meshes[j], where);
      if (whole && addHidden(std::move(*whole), *meshes[j].file, out, where)) continue;
    }
    if (!added) {
      if (options.objects.empty()) common = commonObjects(meshes, j, {files, options}, out);
      return atKey(added.error(), key);
    }
  }
  hintAtUpAxis(meshes[0].kind, writtenZUp, options, std::string(baseName(meshes[0].file->name)), out);
  setTimesInSeconds(out.keyframes);
  nameByActions(actions, out.keyframes.keys);
  warnOfSamePoses(facts, out);
  warnOfSizes(places, out);
  // If no key differs, the files' animations may provide the keys.
  if (samePoses(out) > 0 && (facts.animated == facts.files || facts.posed == facts.files))
    out.animations = std::move(animations);
  return out;
}

}  // namespace

std::string placeName(const NamedBytes& file, int key, std::size_t keys) {
  constexpr std::size_t longest = 120;  // of a URL, for example
  std::string name(baseName(file.name));
  if (name.size() > longest) name = "..." + name.substr(name.size() - longest);
  return keys > 1 && key > 0 ? name + " (key " + std::to_string(key + 1) + ")" : name;
}

std::string keyName(const NamedBytes& file) {
  const std::string_view name = baseName(file.name);
  return std::string(name.substr(0, name.rfind('.')));
}

bool areAll(const std::vector<MeshFile>& meshes, FileKind kind) {
  return std::all_of(meshes.begin(), meshes.end(), [&](const MeshFile& mesh) { return mesh.kind == kind; });
}

Error atKey(Error error, int key) {
  error.key = key;
  return error;
}

// Takes over the pose, so memory holds at most one pose after the first.
Status addPose(PoseFile&& pose, std::string name, Import& out, const std::string& where) {
  out.noteRounding(pose.rounding, name);
  if (out.keyframes.keyCount() > 0)
    return hintAtObjects(
        KeyJoiner(out).add(pose.faces, {{std::move(name), 0, std::move(pose.positions)}}, where, pose.scene.objects),
        pose.objects, out.objects);
  out.keyframes = {std::move(pose.faces), {{std::move(name), 0, std::move(pose.positions)}}, std::move(pose.normals)};
  out.scene = std::move(pose.scene);
  out.warnings = std::move(pose.warnings);
  out.objects = std::move(pose.objects);
  return {};
}

void hintAtUpAxis(FileKind kind, bool writtenZUp, const ImportOptions& options, const std::string& where,
                  Import& import) {
  const bool obj = kind == FileKind::Obj, silent = obj || kind == FileKind::Ply || kind == FileKind::Off;
  if (!silent || options.zUp) return;
  const UpAxisGuess upAxis = guessUpAxis(import.keyframes, !obj);
  if (writtenZUp) import.warnings.push_back(blenderWarning(where, upAxis != UpAxisGuess::AlongY));
  else if (upAxis == UpAxisGuess::AlongZ) import.warnings.push_back(zUpWarning(where, true));
  else if (upAxis == UpAxisGuess::PerhapsAlongZ && !obj) import.warnings.push_back(zUpWarning(where, false));
}

void setTimesInSeconds(Keyframes& keyframes) {
  for (int j = 0; j < keyframes.keyCount(); ++j) keyframes.keys[j].time = j;
}

Result<Import> importPoses(const std::vector<MeshFile>& meshes, const SourceFiles& files, const ImportOptions& options,
                           const StageProgress& progress) {
  std::vector<std::string> common;
  FileFacts facts;
  auto import = readPoses(meshes, files, options, progress, common, facts);
  // A constant action is meant to pose a character stored in its bind pose.
  if (import && facts.isPosed && samePoses(*import) > 0 && !options.posedByActions) {
    ImportOptions posed = options;
    posed.posedByActions = true;
    auto actions = importPoses(meshes, files, posed, progress);
    if (actions && (!options.like.empty() || samePoses(*actions) < samePoses(*import))) return actions;
  }
  if (import || common.empty()) return import;
  ImportOptions narrowed = options;
  narrowed.objects = std::exchange(common, {});
  auto without = readPoses(meshes, files, narrowed, progress, common, facts);
  if (!without) return import;
  std::erase_if(without->warnings, [](const Warning& warning) { return warning.code == "left-out-objects"; });
  without->warnings.push_back(
      leftOutWarning(narrowed.objects, static_cast<int>(without->objects.size() - narrowed.objects.size())));
  without->objects = std::move(narrowed.objects);
  return without;
}

}  // namespace shapespline
