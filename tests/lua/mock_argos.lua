-- SPDX-License-Identifier: MIT
-- ARGoS 3 as a controller's script meets it (docs/argos.md): every name, argument count, type and
-- unit range is checked, and what is not in the interface is an error at once, where ARGoS would say
-- nil. `calls` counts what was called.

local mock = { calls = {} }

local RIM = 0.33               -- m/s: what is meant as cm/s is far more
local LIFT = 0.1375            -- m
local MODES = { constructive = true, destructive = true, disable = true, disabled = true }
local COLOURS = { black = true, magenta = true, orange = true, green = true, blue = true }
local FACES = { 'north', 'east', 'south', 'west', 'top', 'bottom' }
mock.FACES = FACES

local function fail(level, ...)
   error(string.format(...), level + 1)
end

-- A table whose names are these and no others, and that a script does not write to.
local function guard(path, fields)
   return setmetatable({}, {
      __index = function(_, name)
         local value = fields[name]
         if value == nil then fail(2, '%s has no %s', path, tostring(name)) end
         return value
      end,
      __newindex = function(_, name) fail(2, '%s.%s is not for scripts to set', path, tostring(name)) end,
      __pairs = function() return next, fields end,
   })
end

-- Vectors -------------------------------------------------------------------------------------

local Vector2, Vector3, Quaternion = { __name = 'vector2' }, { __name = 'vector3' }, { __name = 'quaternion' }

local function is(value, kind)
   return getmetatable(value) == kind
end

local function need(value, kind)
   if not is(value, kind) then fail(3, '%s expected, got %s', kind.__name, type(value)) end
   return value
end

local function number(value)
   if type(value) ~= 'number' or value ~= value or math.abs(value) == math.huge then
      fail(3, 'a finite number expected, got %s', tostring(value))
   end
   return value
end

local function methods_of(kind, methods)
   kind.__index = function(_, name)
      return methods[name] or fail(2, '%s has no %s', kind.__name, tostring(name))
   end
   kind.__newindex = function(_, name) fail(2, '%s has no %s', kind.__name, tostring(name)) end
end

local function v2(x, y) return setmetatable({ x = number(x), y = number(y) }, Vector2) end
local function v3(x, y, z)
   return setmetatable({ x = number(x), y = number(y), z = number(z) }, Vector3)
end
local function quat(w, x, y, z)
   return setmetatable({ w = number(w), x = number(x), y = number(y), z = number(z) }, Quaternion)
end
mock.v2, mock.v3, mock.quat = v2, v3, quat

methods_of(Vector2, {})

function Vector3.__add(a, b) need(a, Vector3) need(b, Vector3) return v3(a.x + b.x, a.y + b.y, a.z + b.z) end
function Vector3.__sub(a, b) need(a, Vector3) need(b, Vector3) return v3(a.x - b.x, a.y - b.y, a.z - b.z) end
function Vector3.__unm(a) return v3(-a.x, -a.y, -a.z) end
function Vector3.__mul(a, b)
   if type(a) == 'number' then a, b = b, a end
   need(a, Vector3)
   number(b)
   return v3(a.x * b, a.y * b, a.z * b)
end

local function times(p, q)
   return quat(p.w * q.w - p.x * q.x - p.y * q.y - p.z * q.z,
               p.w * q.x + p.x * q.w + p.y * q.z - p.z * q.y,
               p.w * q.y - p.x * q.z + p.y * q.w + p.z * q.x,
               p.w * q.z + p.x * q.y - p.y * q.x + p.z * q.w)
end
function Quaternion.__mul(p, q) return times(need(p, Quaternion), need(q, Quaternion)) end

local function inverse(q) return quat(q.w, -q.x, -q.y, -q.z) end

-- normalize, cross and rotate change the vector that they are called on.
local function set(v, x, y, z)
   v.x, v.y, v.z = number(x), number(y), number(z)
   return v
end
local function length(v) return math.sqrt(v.x * v.x + v.y * v.y + v.z * v.z) end
methods_of(Vector3, {
   length = length,
   dot = function(a, b) need(b, Vector3) return a.x * b.x + a.y * b.y + a.z * b.z end,
   cross = function(a, b)
      need(b, Vector3)
      return set(a, a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x)
   end,
   normalize = function(a) local l = length(a) return set(a, a.x / l, a.y / l, a.z / l) end,
   rotate = function(a, q)
      need(q, Quaternion)
      local r = times(times(q, quat(0, a.x, a.y, a.z)), inverse(q))
      return set(a, r.x, r.y, r.z)
   end,
})
methods_of(Quaternion, { inverse = inverse })

local function make_vector3(...)
   local count, x, y, z = select('#', ...), ...
   if count == 0 then return v3(0, 0, 0) end
   if count == 1 then need(x, Vector3) return v3(x.x, x.y, x.z) end
   if count == 3 then return v3(x, y, z) end
   fail(2, 'invalid arguments to vector3')
end

local function make_quaternion(...)
   local count, a, b, c, d = select('#', ...), ...
   if count == 0 then return quat(1, 0, 0, 0) end
   if count == 1 then need(a, Quaternion) return quat(a.w, a.x, a.y, a.z) end
   if count == 2 then
      number(a)
      need(b, Vector3)
      local s = math.sin(a / 2) / length(b)
      return quat(math.cos(a / 2), s * b.x, s * b.y, s * b.z)
   end
   if count == 4 then return quat(a, b, c, d) end
   fail(2, 'invalid arguments to quaternion')
end
mock.vector3, mock.quaternion = make_vector3, make_quaternion

-- A script -------------------------------------------------------------------------------------

-- Loads a script into a state of its own: devices are what the experiment gives its controller.
-- `read(host)` gives readings, commands go to `act`. Returns the four callbacks by name.
function mock.load(path, devices, id, params, act)
   local env = {}
   for _, name in ipairs { 'assert', 'error', 'ipairs', 'next', 'pairs', 'pcall', 'select', 'tonumber',
                           'tostring', 'type', 'setmetatable', 'getmetatable', 'rawget', 'rawset',
                           'table', 'string', 'coroutine' } do
      env[name] = _G[name]
   end
   env._G, env.math = env, {}
   for name, value in pairs(math) do env.math[name] = value end
   function env.math.random() fail(2, 'a number that is not from the experiment\'s seed') end
   env.vector3, env.quaternion = make_vector3, make_quaternion
   env.vector2 = function(x, y) return v2(x, y) end
   env.log, env.logerr = function(...) act.log(...) end, function(...) act.log(...) end

   local script = { fields = {}, env = env }
   local function call(name, kinds, does)
      return function(...)
         -- ARGoS's functions look for their device in the global `robot`
         if env.robot ~= script.host then fail(2, '%s: robot is not ARGoS\'s any more', name) end
         if select('#', ...) ~= #kinds then
            fail(2, '%s expects %d arguments, got %d', name, #kinds, select('#', ...))
         end
         for i, kind in ipairs(kinds) do
            local value = select(i, ...)
            local good
            if type(kind) == 'table' then good = is(value, kind) else good = type(value) == kind end
            if not good then fail(2, '%s: argument %d is a %s', name, i, type(value)) end
            if kind == 'number' then number(value) end
         end
         mock.calls[name] = (mock.calls[name] or 0) + 1
         return does(...)
      end
   end
   local function within(name, value, low, high)
      if value < low - 1e-9 or value > high + 1e-9 then
         fail(3, '%s: %g is not within %g and %g', name, value, low, high)
      end
   end

   local f = script.fields
   local robot = { id = id, params = params }
   robot.random = guard('robot.random', {
      uniform = call('robot.random.uniform', {}, function() return act.random() end),
   })
   -- Sensors and actuators of one name share a table.
   local function table_of(name)
      f[name] = f[name] or {}
      robot[name] = robot[name] or guard('robot.' .. name, f[name])
      return f[name]
   end
   local has = {}
   for _, device in ipairs(devices) do has[device] = true end
   if has['actuator differential_drive'] then
      table_of('differential_drive').set_target_velocity = call(
         'robot.differential_drive.set_target_velocity', { 'number', 'number' }, function(left, right)
            within('left rim', left, -RIM, RIM)
            within('right rim', right, -RIM, RIM)
            act.velocity(left, right)
         end)
   end
   if has['actuator electromagnet_system'] then
      table_of('electromagnet_system').set_discharge_mode = call(
         'robot.electromagnet_system.set_discharge_mode', { 'string' }, function(mode)
            if not MODES[mode] then fail(3, 'no mode of discharge: %s', mode) end
            act.discharge(mode)
         end)
   end
   if has['actuator lift_system'] then
      local lift = table_of('lift_system')
      lift.set_position = call('robot.lift_system.set_position', { 'number' }, function(height)
         within('lift', height, 0, LIFT)
         act.lift(height)
      end)
      lift.stop = call('robot.lift_system.stop', {}, function() act.lift_stop() end)
      lift.calibrate = call('robot.lift_system.calibrate', {}, function() act.lift_stop() end)
   end
   if has['actuator simple_radios'] then
      for _, name in ipairs(act.radios) do
         table_of('simple_radios')
         f['radio ' .. name] = { send = call('robot.simple_radios.' .. name .. '.send', { 'table' }, function(message)
            if #message == 0 then fail(3, 'an empty message') end
            for key, byte in pairs(message) do
               if math.type(key) ~= 'integer' or math.type(byte) ~= 'integer' or byte < 0 or byte > 255 then
                  fail(3, 'no byte of a message: [%s] = %s', tostring(key), tostring(byte))
               end
            end
            act.send(name, message)
         end) }
         f.simple_radios[name] = guard('robot.simple_radios.' .. name, f['radio ' .. name])
      end
   end
   if has['sensor simple_radios'] then
      for _, name in ipairs(act.radios) do f['radio ' .. name].recv = {} end
   end
   if has['sensor camera_system'] then
      local camera = table_of('camera_system')
      camera.enable = call('robot.camera_system.enable', {}, function() act.camera(true) end)
      camera.disable = call('robot.camera_system.disable', {}, function() act.camera(false) end)
      camera.detect_led = call('robot.camera_system.detect_led', { Vector3 }, function(at)
         within('distance of an LED before the camera', at.z, 0, 1)
         return act.detect_led(at)
      end)
      camera.tags, camera.timestamp, camera.resolution = {}, 0.0, v2(320, 240)
      camera.transform = guard('robot.camera_system.transform', {
         anchor = 'end_effector', position = v3(0, 0, 0.075),
         orientation = times(make_quaternion(0.75 * math.pi, v3(0, 1, 0)),
                             make_quaternion(-0.5 * math.pi, v3(0, 0, 1))),
      })
   end
   if has['sensor differential_drive'] then
      f.encoders = { left = 0.0, right = 0.0 }
      table_of('differential_drive').encoders = guard('robot.differential_drive.encoders', f.encoders)
   end
   if has['sensor electromagnet_system'] then table_of('electromagnet_system').voltage = 0.0 end
   if has['sensor lift_system'] then
      f.switches = { top = 0, bottom = 1 }
      local lift = table_of('lift_system')
      lift.state, lift.position = 'inactive', 0.0
      lift.limit_switches = guard('robot.lift_system.limit_switches', f.switches)
   end
   if has['sensor rangefinders'] then
      for _, name in ipairs(act.finders) do
         f['finder ' .. name] = { proximity = 0.05, illuminance = 0.0 }
         table_of('rangefinders')[name] = guard('robot.rangefinders.' .. name, f['finder ' .. name])
      end
   end
   if has['sensor system'] then
      local system = table_of('system')
      system.time, system.temperature = 0.0, 30.0
   end
   if has['actuator directional_leds'] then
      local leds = table_of('directional_leds')
      leds.set_all_colors = call('robot.directional_leds.set_all_colors', { 'string' }, function(colour)
         if not COLOURS[colour] then fail(3, 'the camera knows no %s', colour) end
         act.colour(colour)
      end)
      leds.set_single_color = call('robot.directional_leds.set_single_color', { 'number', 'string' },
                                   function(led, colour)
         if not COLOURS[colour] then fail(3, 'the camera knows no %s', colour) end
         act.led(led, colour)
      end)
   end
   script.host = guard('robot', robot)
   env.robot = script.host
   assert(loadfile(path, 't', env))()
   for _, name in ipairs { 'init', 'step', 'reset', 'destroy' } do
      if type(env[name]) ~= 'function' then fail(2, '%s: ARGoS calls %s, which is not there', path, name) end
      script[name] = env[name]
   end
   return script
end

-- A tag as the camera's sensor says it.
function mock.tag(number_on_it, position, orientation, center, corners)
   return guard('tag', {
      id = number_on_it, position = position, orientation = orientation, center = center, corners = corners,
   })
end

return mock
