-- Nothing calls a function of this name.
function on_step()
  robot.directional_leds.set_all_colors(1)
end
