#include "io/gltf/gltf_document.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/base/format.h"
#include "io/base/byte_text.h"
#include "io/base/image_type.h"
#include "io/gltf/glb_container.h"
#include "io/gltf/gltf_json.h"
#include "io/gltf/gltf_parts.h"
#include "io/gltf/malformed.h"

namespace shapespline {

namespace {

using nlohmann::json;

std::uint64_t whole(const json& object, const char* name, std::uint64_t otherwise) {
  const auto it = object.find(name);
  return it != object.end() && it->is_number_unsigned() ? it->get<std::uint64_t>() : otherwise;
}

struct Source {
  const NamedBytes& file;
  const SourceFiles& files;
  GlbChunks chunks;
};

Result<Resource> readBuffer(const json& buffer, std::size_t index, const Source& source, const std::string& where) {
  const std::string name = "buffer " + std::to_string(index);
  const auto uri = buffer.find("uri");
  if (!buffer.contains("byteLength")) return malformed(where, name + " has no byteLength");
  Resource resource;
  if (uri != buffer.end()) {
    if (!uri->is_string()) return malformed(where, "the URI of " + name + " is not text");
    auto found = resolveUri(uri->get_ref<const std::string&>(), source.file.name, source.files, where);
    if (!found) return found;
    resource = std::move(*found);
  } else {
    if (index != 0 || !source.chunks.hasBin) return resource;  // a placeholder, an error only when read
    resource.bytes = source.chunks.bin;
  }
  const std::uint64_t declared = whole(buffer, "byteLength", 0);
  if (declared > resource.bytes.size())
    return Error{ErrorCode::TruncatedFile, where + ": " + name + " declares " + sizeText(declared) + " but has only " +
                                               sizeText(resource.bytes.size()) + ". Copy or export it again."};
  resource.bytes = resource.bytes.first(declared);
  return resource;
}

Status readBuffers(const json& doc, const Source& source, GltfDocument& out) {
  const auto buffers = doc.find("buffers");
  if (buffers == doc.end()) return {};
  out.buffers.reserve(buffers->size());
  for (const json& buffer : *buffers) {
    auto resource = readBuffer(buffer, out.buffers.size(), source, out.where);
    if (!resource) return resource.error();
    out.bufferBytes += resource->bytes.size();
    out.buffers.push_back(std::move(*resource));
  }
  return {};
}

// The bytes of a buffer view, or nothing if a part is out of bounds.
std::span<const std::uint8_t> viewBytes(const json& doc, std::uint64_t view, const GltfDocument& out) {
  const auto views = doc.find("bufferViews");
  if (views == doc.end() || view >= views->size()) return {};
  const json& v = (*views)[view];
  const std::uint64_t buffer = whole(v, "buffer", out.buffers.size());
  const std::uint64_t offset = whole(v, "byteOffset", 0), length = whole(v, "byteLength", 0);
  if (buffer >= out.buffers.size()) return {};
  const auto bytes = out.buffers[buffer].bytes;
  if (offset > bytes.size() || length > bytes.size() - offset) return {};
  return bytes.subspan(offset, length);
}

// A missing image loses its texture, but not the shape. Images may share bytes, so a small file could declare any
// amount: their total is limited to the size of the files.
void readImages(const json& doc, const Source& source, GltfDocument& out) {
  const auto images = doc.find("images");
  if (images == doc.end()) return;
  std::uint64_t room = source.files.bytes();
  std::size_t missing = 0;
  std::string first;
  std::map<const std::uint8_t*, int> known;
  for (const json& image : *images) {
    const std::string name = out.where + ", image " + std::to_string(out.imageOf.size()) + ",";
    const auto uri = image.find("uri");
    Resource resource;
    std::string why = name + " has no bytes in the file.";
    if (uri != image.end() && uri->is_string()) {
      auto found = resolveUri(uri->get_ref<const std::string&>(), source.file.name, source.files, name);
      if (found) resource = std::move(*found);
      else why = found.error().message;
    } else if (image.contains("bufferView")) {
      resource.bytes = viewBytes(doc, whole(image, "bufferView", ~0ull), out);
    }
    const auto same = known.find(resource.bytes.data());
    if (same != known.end() && out.images[same->second].bytes.size() == resource.bytes.size()) {
      out.imageOf.push_back(same->second);
      continue;
    }
    const std::string type = imageType(resource.bytes);
    if (!resource.bytes.empty() && type.empty()) why = name + " is not in a supported image format.";
    const bool fits = resource.bytes.size() <= room;
    if (!fits) why = name + " repeats the bytes of other images too often.";
    const bool usable = fits && !type.empty();
    out.imageOf.push_back(usable ? static_cast<int>(out.images.size()) : -1);
    if (!usable && ++missing == 1) first = why;
    if (!usable) continue;
    room -= resource.bytes.size();
    if (resource.owned.empty()) known[resource.bytes.data()] = out.imageOf.back();
    out.images.push_back({type, {resource.bytes.begin(), resource.bytes.end()}});
  }
  if (missing == 0) return;
  const std::string what = missing == 1 ? "An image is ignored: "
                                        : grouped(std::int64_t(missing)) + " images are ignored. The first of them: ";
  out.warnings.push_back({"missing-texture", what + first, static_cast<int>(missing)});
}

// The first line of a tinygltf message, formatted for use inside a sentence.
std::string oneLine(const std::string& message) {
  std::string line = message.substr(0, std::min<std::size_t>(message.find('\n'), 200));
  for (char& c : line)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  while (!line.empty() && (line.back() == '.' || line.back() == ' ')) line.pop_back();
  return line;
}

// A file without nodes shows each mesh once.
void showBareMeshes(tinygltf::Model& model) {
  if (!model.nodes.empty()) return;
  model.nodes.resize(model.meshes.size());
  for (std::size_t m = 0; m < model.meshes.size(); ++m) model.nodes[m].mesh = static_cast<int>(m);
  model.scenes.clear();
}

Status loadModel(json doc, GltfDocument& out) {
  for (const char* unread : {"buffers", "images", "cameras", "extensions", "extras"}) doc.erase(unread);
  const std::string text = doc.dump();
  doc = nullptr;  // tinygltf makes a copy; keeping both would double the peak
  tinygltf::TinyGLTF loader;
  std::string error, warning;
  if (!loader.LoadASCIIFromString(&out.model, &error, &warning, text.data(), static_cast<unsigned>(text.size()), ""))
    return malformed(out.where, "it is not valid glTF" + (error.empty() ? "" : " (" + oneLine(error) + ")"));
  showBareMeshes(out.model);
  return {};
}

}  // namespace

std::string brokenPart(const tinygltf::Value& extras) {
  return extras.Has(brokenMember) ? " cannot be read (" + extras.Get(brokenMember).Get<std::string>() + ")" : "";
}

Result<GltfDocument> openGltf(const NamedBytes& file, const SourceFiles& files, const std::string& where) {
  Source source{file, files, {}};
  if (isGlb(file.bytes)) {
    auto chunks = splitGlb(file.bytes, where);
    if (!chunks) return chunks.error();
    source.chunks = *chunks;
  } else {
    source.chunks.json = {reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()};
  }
  GltfDocument out;
  auto doc = parseGltfJson(source.chunks.json, where, out.warnings);
  if (!doc) return doc.error();

  out.where = where;
  if (const auto& extras = (*doc)["extras"]; extras.is_object() && extras.contains("shapespline"))
    out.project = extras["shapespline"].dump();
  if (Status buffers = readBuffers(*doc, source, out); !buffers) return buffers.error();
  out.fileBytes += files.bytes();
  out.fileBytes = std::min<std::uint64_t>(out.fileBytes, source.chunks.json.size() + out.bufferBytes);
  readImages(*doc, source, out);
  if (Status model = loadModel(std::move(*doc), out); !model) return model.error();
  return out;
}

}  // namespace shapespline
