#include "io/gltf/gltf_accessor.h"

#include <algorithm>
#include <cstring>
#include <optional>

#include "core/base/format.h"
#include "io/base/byte_text.h"
#include "io/base/limits.h"

namespace shapespline {

namespace {

int componentBytes(int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT: return 4;
    default: return 0;
  }
}

template <class T>
T load(const std::uint8_t* from) {
  T value;
  std::memcpy(&value, from, sizeof value);  // glTF is little endian, like every machine this runs on
  return value;
}

template <class T>
double fraction(const std::uint8_t* from) {
  return std::max(load<T>(from) / static_cast<double>(std::numeric_limits<T>::max()), -1.0);
}

double number(const std::uint8_t* from, int type, bool normalised) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE: return normalised ? fraction<std::int8_t>(from) : load<std::int8_t>(from);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return normalised ? fraction<std::uint8_t>(from) : load<std::uint8_t>(from);
    case TINYGLTF_COMPONENT_TYPE_SHORT: return normalised ? fraction<std::int16_t>(from) : load<std::int16_t>(from);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return normalised ? fraction<std::uint16_t>(from) : load<std::uint16_t>(from);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT: return load<std::uint32_t>(from);
    default: return load<float>(from);
  }
}

std::uint32_t wholeNumber(const std::uint8_t* from, int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return load<std::uint8_t>(from);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return load<std::uint16_t>(from);
    default: return load<std::uint32_t>(from);
  }
}

// `count` elements of `size` bytes at distance `stride`, all inside their buffer.
struct Elements {
  const std::uint8_t* first = nullptr;
  std::size_t stride = 0;
  const std::uint8_t* at(std::size_t i) const { return first + i * stride; }
};

struct Reader {
  const GltfDocument& doc;
  const std::string& what;

  Error malformed(const std::string& problem) const {
    return {ErrorCode::MalformedFile, doc.where + ": " + what + " " + problem + ". Export the file again."};
  }

  // All numbers come from JSON and are below 2^31, so sums and products fit 64 bits.
  Result<Elements> elements(int viewIndex, std::uint64_t offset, std::uint64_t count, std::uint64_t size) const {
    const auto& views = doc.model.bufferViews;
    if (viewIndex < 0 || viewIndex >= static_cast<int>(views.size()))
      return malformed("refers to a buffer view that does not exist");
    const tinygltf::BufferView& view = views[viewIndex];
    if (const std::string broken = brokenPart(view.extras); !broken.empty())
      return malformed("uses a buffer view that" + broken);
    if (view.buffer < 0 || view.buffer >= static_cast<int>(doc.buffers.size()))
      return malformed("refers to a buffer that does not exist");
    const auto buffer = doc.buffers[view.buffer].bytes;
    if (buffer.empty()) return malformed("uses buffer " + std::to_string(view.buffer) + ", which has no bytes");
    if (std::uint64_t{view.byteOffset} + view.byteLength > buffer.size())
      return malformed("uses a buffer view that ends at byte " +
                       grouped(std::int64_t(view.byteOffset + view.byteLength)) + " of a buffer of " +
                       sizeText(buffer.size()));
    const std::uint64_t stride = view.byteStride ? view.byteStride : size;
    if (stride < size) return malformed("has a stride smaller than its elements");
    const std::uint64_t end = count == 0 ? 0 : offset + (count - 1) * stride + size;
    if (end > view.byteLength)
      return malformed("needs " + sizeText(end) + " but its buffer view has only " + sizeText(view.byteLength));
    return Elements{buffer.data() + view.byteOffset + offset, static_cast<std::size_t>(stride)};
  }

  Result<const tinygltf::Accessor*> accessor(int index, int components) const {
    const auto& accessors = doc.model.accessors;
    if (index < 0 || index >= static_cast<int>(accessors.size()))
      return malformed("refers to an accessor that does not exist");
    const tinygltf::Accessor& a = accessors[index];
    if (const std::string broken = brokenPart(a.extras); !broken.empty()) return malformed(broken.substr(1));
    if (componentBytes(a.componentType) == 0) return malformed("has an unknown component type");
    if (tinygltf::GetNumComponentsInType(a.type) != components)
      return malformed("does not have " + std::to_string(components) + " components");
    if (a.bufferView < 0 && a.count > maxElements)
      return Error{ErrorCode::TooLarge, doc.where + ": " + what + " declares " + grouped(std::int64_t(a.count)) +
                                            " elements, more than is supported. Simplify the mesh first."};
    return &a;
  }

  // Indices of the elements that a sparse accessor replaces, checked to be in range.
  Result<std::vector<std::uint32_t>> sparseIndices(const tinygltf::Accessor& a) const {
    const int type = a.sparse.indices.componentType;
    const bool isUnsigned = type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                            type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
                            type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    if (!isUnsigned) return malformed("has sparse indices of an unknown type");
    if (a.sparse.count < 0 || static_cast<std::uint64_t>(a.sparse.count) > a.count)
      return malformed("has more sparse indices than elements");
    const auto found =
        elements(a.sparse.indices.bufferView, a.sparse.indices.byteOffset, a.sparse.count, componentBytes(type));
    if (!found) return found.error();
    std::vector<std::uint32_t> indices(a.sparse.count);
    for (std::size_t i = 0; i < indices.size(); ++i) {
      indices[i] = wholeNumber(found->at(i), type);
      if (indices[i] >= a.count)
        return malformed("has the sparse index " + grouped(indices[i]) + ", but only " +
                         grouped(std::int64_t(a.count)) + " elements (0 to " + grouped(std::int64_t(a.count) - 1) +
                         ")");
    }
    return indices;
  }

  // Passes the bytes of the first `most` elements to `take`, sparse replacements last. Elements without a buffer view
  // are zero.
  template <class Take>
  Status each(const tinygltf::Accessor& a, int components, std::size_t most, const FractionReport& onProgress,
              Take take) const {
    const std::uint64_t size = static_cast<std::uint64_t>(componentBytes(a.componentType)) * components;
    if (a.bufferView >= 0) {
      const auto found = elements(a.bufferView, a.byteOffset, a.count, size);
      if (!found) return found.error();
      inBlocks(partOf(onProgress, 0, a.sparse.isSparse ? 0.5 : 1), most, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) take(i, found->at(i));
      });
    }
    if (!a.sparse.isSparse) return {};
    const auto indices = sparseIndices(a);
    if (!indices) return indices.error();
    const auto values = elements(a.sparse.values.bufferView, a.sparse.values.byteOffset, indices->size(), size);
    if (!values) return values.error();
    inBlocks(partOf(onProgress, 0.5, 1), indices->size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        if ((*indices)[i] < most) take((*indices)[i], values->at(i));
    });
    return {};
  }

  // Checks that the file contains the accessor's bytes, before allocating memory for them.
  Status fits(const tinygltf::Accessor& a, int components) const {
    if (a.bufferView < 0) return {};
    const auto found =
        elements(a.bufferView, a.byteOffset, a.count, std::uint64_t(componentBytes(a.componentType)) * components);
    return found ? Status() : Status(found.error());
  }
};

}  // namespace

std::size_t accessorCount(const GltfDocument& doc, int index) {
  return index >= 0 && index < static_cast<int>(doc.model.accessors.size()) ? doc.model.accessors[index].count : 0;
}

Result<std::vector<double>> readNumbers(const GltfDocument& doc, int index, int components, const std::string& what,
                                        std::size_t most, const FractionReport& onProgress) {
  const Reader reader{doc, what};
  const auto found = reader.accessor(index, components);
  if (!found) return found.error();
  const tinygltf::Accessor& a = **found;
  if (Status fits = reader.fits(a, components); !fits) return fits.error();
  const std::size_t count = std::min<std::size_t>(a.count, most);
  std::vector<double> numbers(count * components);
  const int step = componentBytes(a.componentType);
  Status read = reader.each(a, components, count, onProgress, [&](std::size_t i, const std::uint8_t* bytes) {
    for (int c = 0; c < components; ++c)
      numbers[i * components + c] = number(bytes + c * step, a.componentType, a.normalized);
  });
  if (!read) return read.error();
  return numbers;
}

Result<std::vector<std::uint32_t>> readWholeNumbers(const GltfDocument& doc, int index, int components,
                                                    const std::string& what, const FractionReport& onProgress) {
  const Reader reader{doc, what};
  const auto found = reader.accessor(index, components);
  if (!found) return found.error();
  const tinygltf::Accessor& a = **found;
  const bool isUnsigned = a.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                          a.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
                          a.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
  if (!isUnsigned) return reader.malformed("does not have an unsigned integer type");
  if (Status fits = reader.fits(a, components); !fits) return fits.error();
  std::vector<std::uint32_t> numbers(a.count * components);
  const int step = componentBytes(a.componentType);
  Status read = reader.each(a, components, a.count, onProgress, [&](std::size_t i, const std::uint8_t* bytes) {
    for (int c = 0; c < components; ++c) numbers[i * components + c] = wholeNumber(bytes + c * step, a.componentType);
  });
  if (!read) return read.error();
  return numbers;
}

}  // namespace shapespline
