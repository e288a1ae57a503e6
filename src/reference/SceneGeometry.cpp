#include "reference/SceneGeometry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "reference/Sheets.h"

namespace limpid::reference {

struct SceneGeometry::Shape {
    std::vector<glm::dvec3> positions; ///< m from the origin
    std::shared_ptr<const Mesh> mesh;
    Sheets sheets;
    RTCScene alone = nullptr; ///< this receiver by itself

    glm::dvec3 corner(unsigned face, unsigned c) const { return positions[mesh->indices[3 * face + c]]; }
    /// Along the normal, as long as twice the face's area.
    glm::dvec3 across(unsigned face) const {
        const glm::dvec3 a = corner(face, 0);
        return glm::cross(corner(face, 1) - a, corner(face, 2) - a);
    }
};

struct SceneGeometry::ShownContext {
    RTCIntersectContext context; ///< first, so that Embree's pointer is one to all of it
    const Shape* shape;
    const FaceSorting* faces;
    int facing;
    double level; ///< relative to Embree's middle
};

SceneGeometry::SceneGeometry(const Scene& scene, const glm::dvec3& origin) {
    _device = rtcNewDevice(nullptr);
    if (!_device) throw std::runtime_error("Embree: expected a device, found none");
    const Bounds bounds = worldBounds(scene);
    if (!bounds.empty()) _middle = bounds.center() - origin;
    _all = rtcNewScene(_device);
    rtcSetSceneFlags(_all, RTC_SCENE_FLAG_ROBUST);
    for (const Receiver& receiver : scene.receivers)
        addReceiver(receiver, origin);
    rtcCommitScene(_all);
    if (rtcGetDeviceError(_device) != RTC_ERROR_NONE)
        throw std::runtime_error("Embree: cannot build the scene");
}

SceneGeometry::~SceneGeometry() {
    for (const auto& shape : _shapes)
        rtcReleaseScene(shape->alone);
    rtcReleaseScene(_all);
    rtcReleaseDevice(_device);
}

void SceneGeometry::addReceiver(const Receiver& receiver, const glm::dvec3& origin) {
    auto shape = std::make_unique<Shape>();
    shape->mesh = receiver.mesh;
    shape->sheets = Sheets(*receiver.mesh);
    _translucent = _translucent || !shape->sheets.none();
    for (const glm::dvec3& p : receiver.mesh->positions) {
        shape->positions.push_back(receiver.toWorld(p) - origin);
        _top = std::max(_top, shape->positions.back().y);
    }
    const std::size_t corners = shape->positions.size(), faces = receiver.mesh->triangleCount();
    const RTCGeometry geometry = rtcNewGeometry(_device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* points =
        static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                    3 * sizeof(float), std::max(corners, std::size_t(1))));
    auto* indices = static_cast<std::uint32_t*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(std::uint32_t), std::max(faces, std::size_t(1))));
    if (!points || !indices) throw std::bad_alloc();
    for (std::size_t i = 0; i < corners; ++i)
        for (int c = 0; c < 3; ++c)
            *points++ = float(shape->positions[i][c] - _middle[c]);
    std::copy_n(receiver.mesh->indices.begin(), 3 * faces, indices);
    rtcSetGeometryUserData(geometry, shape.get());
    if (!shape->sheets.none()) {
        rtcSetGeometryIntersectFilterFunction(geometry, filterHoles);
        rtcSetGeometryOccludedFilterFunction(geometry, filterHoles);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(_all, geometry, unsigned(_shapes.size()));
    shape->alone = rtcNewScene(_device);
    rtcSetSceneFlags(shape->alone,
                     RTCSceneFlags(RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
    rtcAttachGeometryByID(shape->alone, geometry, 0);
    rtcCommitScene(shape->alone);
    rtcReleaseGeometry(geometry);
    _shapes.push_back(std::move(shape));
}

RTCRayHit SceneGeometry::ray(const glm::dvec3& from, const glm::dvec3& direction) const {
    const glm::vec3 start(from - _middle), way(direction);
    RTCRayHit query{};
    query.ray = {start.x, start.y, start.z, 0, way.x, way.y, way.z, 0, std::numeric_limits<float>::infinity(),
                 ~0u,     0,       0};
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    return query;
}

Hit SceneGeometry::refined(const Shape& shape, int receiver, const RTCRayHit& query, const glm::dvec3& from,
                           const glm::dvec3& direction) const {
    const unsigned face = query.hit.primID;
    const glm::dvec3 across = shape.across(face);
    const double size = glm::length(across);
    Hit hit;
    hit.receiver = receiver;
    hit.normal = size > 0 ? across / size : -direction;
    hit.distance = double(query.ray.tfar);
    // Along a face that the ray nearly lies in, the crossing is no better known than Embree has it.
    if (const double facing = glm::dot(hit.normal, direction); std::abs(facing) > 1e-4)
        hit.distance = glm::dot(hit.normal, shape.corner(face, 0) - from) / facing;
    hit.point = from + hit.distance * direction;
    hit.transmittance = shape.sheets.transmittance(*shape.mesh, face, {query.hit.u, query.hit.v});
    hit.shown = shape.sheets.isShown(*shape.mesh, face, {query.hit.u, query.hit.v});
    hit.reach = double(query.ray.tfar);
    return hit;
}

Hit SceneGeometry::nearest(RTCRayHit& query, const glm::dvec3& from, const glm::dvec3& direction) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect1(_all, &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    return refined(*_shapes[query.hit.geomID], int(query.hit.geomID), query, from, direction);
}

Hit SceneGeometry::first(const glm::dvec3& from, const glm::dvec3& direction) const {
    RTCRayHit query = ray(from, direction);
    return nearest(query, from, direction);
}

Hit SceneGeometry::next(const glm::dvec3& from, const glm::dvec3& direction, const Hit& passed) const {
    // Past all that a float may take for the same place: of two faces that share an edge one is met.
    constexpr double rounding = 2e-6;
    RTCRayHit query = ray(from, direction);
    query.ray.tnear = float(passed.reach + rounding * (glm::length(from - _middle) + passed.reach));
    return nearest(query, from, direction);
}

glm::dvec3 SceneGeometry::through(const glm::dvec3& from, const glm::dvec3& direction,
                                  double distance) const {
    if (!blocked(from, direction, distance)) return glm::dvec3(1);
    if (!_translucent) return glm::dvec3(0);
    glm::dvec3 share(1);
    Hit hit = first(from, direction);
    for (int i = 0; hit && hit.distance < distance && share != glm::dvec3(0); ++i) {
        share *= i < mostSheets ? hit.transmittance : glm::dvec3(0);
        hit = next(from, direction, hit);
    }
    return share;
}

bool SceneGeometry::blocked(const glm::dvec3& from, const glm::dvec3& direction, double distance) const {
    RTCRayHit query = ray(from, direction);
    query.ray.tfar = float(distance);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(_all, &context, &query.ray);
    return query.ray.tfar < 0;
}

Hit SceneGeometry::firstShown(int receiver, const glm::dvec3& from, const glm::dvec3& direction, double level,
                              const FaceSorting& faces, int facing) const {
    RTCRayHit query = ray(from, direction);
    const Shape& shape = *_shapes[std::size_t(receiver)];
    ShownContext context{{}, &shape, &faces, facing, level - _middle.y};
    rtcInitIntersectContext(&context.context);
    context.context.filter = filterShown;
    rtcIntersect1(shape.alone, &context.context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    return refined(shape, receiver, query, from, direction);
}

void SceneGeometry::filterHoles(const RTCFilterFunctionNArguments* arguments) {
    const Shape& shape = *static_cast<const Shape*>(arguments->geometryUserPtr);
    for (unsigned i = 0; i < arguments->N; ++i) {
        if (arguments->valid[i] == 0) continue;
        const glm::vec2 uv(RTCHitN_u(arguments->hit, arguments->N, i),
                           RTCHitN_v(arguments->hit, arguments->N, i));
        const glm::vec3 through =
            shape.sheets.transmittance(*shape.mesh, RTCHitN_primID(arguments->hit, arguments->N, i), uv);
        if (through == glm::vec3(1)) arguments->valid[i] = 0;
    }
}

void SceneGeometry::filterShown(const RTCFilterFunctionNArguments* arguments) {
    const auto& shown = *reinterpret_cast<const ShownContext*>(arguments->context);
    for (unsigned i = 0; i < arguments->N; ++i) {
        if (arguments->valid[i] == 0) continue;
        RTCRayN* ray = arguments->ray;
        const double start = double(RTCRayN_org_y(ray, arguments->N, i)),
                     way = double(RTCRayN_tfar(ray, arguments->N, i));
        // A sheet in the level itself is shown, all of it.
        const double rounding = 4e-7 * (std::abs(start) + way);
        const double y = start + way * double(RTCRayN_dir_y(ray, arguments->N, i)) - rounding;
        const unsigned face = RTCHitN_primID(arguments->hit, arguments->N, i);
        const glm::dvec3 across = shown.shape->across(face);
        const double size = glm::length(across);
        const glm::vec2 uv(RTCHitN_u(arguments->hit, arguments->N, i),
                           RTCHitN_v(arguments->hit, arguments->N, i));
        if (y > shown.level || !(size > 0) || !shown.faces->shows(shown.facing, across / size) ||
            !shown.shape->sheets.isShown(*shown.shape->mesh, face, uv))
            arguments->valid[i] = 0;
    }
}

} // namespace limpid::reference
