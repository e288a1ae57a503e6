#include "io/gltf/Draco.h"

#include <cstring>
#include <memory>
#include <span>

#include <draco/compression/decode.h>
#include <draco/compression/point_cloud/point_cloud_decoder.h>
#include <draco/core/varint_decoding.h>
#include <draco/metadata/metadata_decoder.h>
#include <fmt/format.h>

#include "io/Files.h"
#include "io/gltf/Accessor.h"
#include "io/gltf/Compressed.h"

namespace limpid::io {

namespace {

/// What a stream says of itself before the decoder believes it.
struct Claim {
    std::uint32_t faces = 0;
    std::uint32_t points = 0;
};

/// Of a stream of version 2.2, which is the extension's. Draco makes room for as many faces as a stream
/// claims without a look at how long it is. False if it is no such stream.
bool readClaim(std::span<const std::uint8_t> bytes, Claim& claim) {
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    draco::DracoHeader header;
    if (!draco::PointCloudDecoder::DecodeHeader(&buffer, &header).ok()) return false;
    if (header.encoder_type != draco::TRIANGULAR_MESH || header.version_major != 2 ||
        header.version_minor != 2)
        return false;
    buffer.set_bitstream_version(draco::kDracoMeshBitstreamVersion);
    draco::GeometryMetadata metadata;
    if ((header.flags & METADATA_FLAG_MASK) &&
        !draco::MetadataDecoder().DecodeGeometryMetadata(&buffer, &metadata))
        return false;
    std::uint8_t traversal = 0;
    if (header.encoder_method == draco::MESH_EDGEBREAKER_ENCODING)
        return buffer.Decode(&traversal) && draco::DecodeVarint(&claim.points, &buffer) &&
               draco::DecodeVarint(&claim.faces, &buffer);
    return draco::DecodeVarint(&claim.faces, &buffer) && draco::DecodeVarint(&claim.points, &buffer);
}

std::unique_ptr<draco::Mesh> decodeMesh(GltfFile& file, const std::string& place,
                                        std::span<const std::uint8_t> bytes) {
    Claim claim;
    if (!readClaim(bytes, claim))
        file.fail(place, "a Draco mesh of version 2.2", fmt::format("{} bytes that are none", bytes.size()));
    file.claimDecompressed(place, 12 * (std::size_t(claim.faces) + claim.points));
    std::string error;
    try {
        draco::DecoderBuffer buffer;
        buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        auto decoded = draco::Decoder().DecodeMeshFromBuffer(&buffer);
        if (decoded.ok() && decoded.value()) return std::move(decoded).value();
        error = decoded.status().error_msg_string();
    } catch (const std::exception& failure) {
        error = failure.what();
    }
    file.fail(place, "a Draco mesh", "an error: " + oneLine(error));
}

int addAccessor(GltfFile& file, tinygltf::Accessor accessor, std::vector<unsigned char> data) {
    accessor.bufferView = file.addBuffer(std::move(data));
    accessor.byteOffset = 0;
    accessor.sparse.isSparse = false;
    file.model.accessors.push_back(std::move(accessor));
    return static_cast<int>(file.model.accessors.size()) - 1;
}

/// The elements of an attribute, point by point; none if one of them cannot be had as a T.
template <typename T>
std::vector<unsigned char> convert(const draco::PointAttribute& attribute, std::size_t points) {
    const auto components = static_cast<std::int8_t>(attribute.num_components());
    const std::size_t size = static_cast<std::size_t>(components) * sizeof(T);
    std::vector<unsigned char> data(points * size);
    std::vector<T> element(static_cast<std::size_t>(components));
    for (std::size_t i = 0; i < points; ++i) {
        const draco::AttributeValueIndex value =
            attribute.mapped_index(draco::PointIndex(static_cast<std::uint32_t>(i)));
        if (value.value() >= attribute.size() ||
            !attribute.ConvertValue<T>(value, components, element.data()))
            return {};
        std::memcpy(data.data() + i * size, element.data(), size);
    }
    return data;
}

std::vector<unsigned char> convertTo(int componentType, const draco::PointAttribute& attribute,
                                     std::size_t points) {
    switch (componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
        return convert<std::int8_t>(attribute, points);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return convert<std::uint8_t>(attribute, points);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
        return convert<std::int16_t>(attribute, points);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return convert<std::uint16_t>(attribute, points);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return convert<std::uint32_t>(attribute, points);
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
        return convert<float>(attribute, points);
    default:
        return {};
    }
}

/// An accessor like `index`, which says of what type an attribute is, with the attribute's decoded values.
int addAttribute(GltfFile& file, const std::string& place, int index, const draco::Mesh& mesh,
                 std::uint32_t id) {
    file.requireIndex(place, index, file.model.accessors.size());
    tinygltf::Accessor accessor = file.model.accessors[static_cast<std::size_t>(index)];
    const draco::PointAttribute* attribute = mesh.GetAttributeByUniqueId(id);
    if (!attribute) file.fail(place, "an attribute of the Draco mesh", fmt::format("id {}", id));
    const int components = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
    if (attribute->num_components() != components)
        file.fail(place, fmt::format("{} components, as its accessor has", components),
                  fmt::format("{} in the Draco mesh", attribute->num_components()));
    const std::size_t points = mesh.num_points();
    const int size = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType));
    if (size > 0) file.claimDecompressed(place, points * static_cast<std::size_t>(components * size));
    std::vector<unsigned char> data = convertTo(accessor.componentType, *attribute, points);
    if (data.empty() && points > 0)
        file.fail(place, fmt::format("values of component type {}", accessor.componentType),
                  "others in the Draco mesh");
    accessor.count = points;
    return addAccessor(file, std::move(accessor), std::move(data));
}

int addIndices(GltfFile& file, const std::string& place, const draco::Mesh& mesh) {
    file.claimDecompressed(place, 12 * std::size_t(mesh.num_faces()));
    std::vector<unsigned char> data(12 * std::size_t(mesh.num_faces()));
    for (std::uint32_t i = 0; i < mesh.num_faces(); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t corner = mesh.face(draco::FaceIndex(i))[c].value();
            std::memcpy(data.data() + 12 * std::size_t(i) + 4 * c, &corner, sizeof corner);
        }
    tinygltf::Accessor accessor;
    accessor.type = TINYGLTF_TYPE_SCALAR;
    accessor.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    accessor.count = 3 * std::size_t(mesh.num_faces());
    return addAccessor(file, std::move(accessor), std::move(data));
}

void decodePrimitive(GltfFile& file, const std::string& place, tinygltf::Primitive& primitive,
                     const tinygltf::Value& object) {
    const std::string extension = place + ".KHR_draco_mesh_compression";
    const int view = indexMember(file, extension, object, "bufferView");
    const auto mesh = decodeMesh(file, extension, bufferViewBytes(file, extension + ".bufferView", view));
    const tinygltf::Value& ids = object.Get("attributes");
    for (auto& [name, accessor] : primitive.attributes) {
        // The Draco mesh may leave attributes to the file.
        if (!ids.IsObject() || !ids.Has(name)) continue;
        const std::size_t id = sizeMember(file, extension + ".attributes", ids, name.c_str(), true);
        accessor = addAttribute(file, fmt::format("{}.attributes.{}", place, oneLine(name, 40)), accessor,
                                *mesh, static_cast<std::uint32_t>(id));
    }
    primitive.indices = addIndices(file, extension, *mesh);
    primitive.mode = TINYGLTF_MODE_TRIANGLES; // Draco knows no strips, whatever the primitive was before
}

} // namespace

void decodeDraco(GltfFile& file) {
    for (std::size_t m = 0; m < file.model.meshes.size(); ++m)
        for (std::size_t p = 0; p < file.model.meshes[m].primitives.size(); ++p) {
            tinygltf::Primitive& primitive = file.model.meshes[m].primitives[p];
            const auto* object = extensionObject(primitive.extensions, "KHR_draco_mesh_compression");
            if (object)
                decodePrimitive(file, fmt::format("meshes[{}].primitives[{}]", m, p), primitive, *object);
        }
}

} // namespace limpid::io
